using System;
using System.IO;
using Companion._1;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Options;
using Rabit.Core;
using Rabit.Diagnostics;
using Rabit.Hosting;

// The companion computer as a service. Its settings are in appsettings.json of the folder that it runs in, in the
// environment (Uav__SystemId=7) and on the command line (--Uav:SystemId 7).
try
{
    HostApplicationBuilder builder = Host.CreateApplicationBuilder(args);
    // A start that fails would be in the log with its stack; below it is said in a line for each fault.
    builder.Logging.AddFilter("Microsoft.Extensions.Hosting.Internal.Host", LogLevel.None);
    builder.AddCompanion();
    using IHost host = builder.Build();
    await host.StartAsync();
    RabitReactor reactor = host.Services.GetRequiredService<HostedReactors>()["rabit"];
    using var diagnostics = RabitDiagnostics.Open(reactor);   // "rabit top" shows the managers while they run
    await host.WaitForShutdownAsync();   // until SIGTERM, Ctrl-C, or the end of the managers
    return Environment.ExitCode;         // theirs
}
catch (OperationCanceledException)
{
    return 0;   // SIGTERM while it started
}
catch (Exception e) when (e is RabitHostingException or RabitWiringException or OptionsValidationException
    or InvalidOperationException or InvalidDataException)
{
    Console.Error.WriteLine(e.Message);   // what is wrong with settings, files and wiring, by name
    return 2;
}
