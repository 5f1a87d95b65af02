using System;
using Rabit.Latency;

return Runner.Run(args, Console.Out, Console.Error);
