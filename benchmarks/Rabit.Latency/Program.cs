using System;
using Rabit.Latency;
using Rabit.Latency.StartUp;

return StartUpProgram.IsAsked(args) ? StartUpProgram.Run(args[0]) : Runner.Run(args, Console.Out, Console.Error);
