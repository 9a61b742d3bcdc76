DEMOS = ()
