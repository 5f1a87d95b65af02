using System;
using System.Linq;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Diagnostics.HealthChecks;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Rabit.Diagnostics;
using Rabit.Hosting;
using Rabit.Uav.Hosting;
using UavService;

// The companion computer as a service: what it is made of stands in appsettings.json of the folder that it runs in.
if (args.Contains("--help"))
    return Messages.Help();
bool onlyChecks = args.Contains("--check");
try
{
    string[] settings = args.Where(a => a != "--check").ToArray();
    HostApplicationBuilder builder = Host.CreateApplicationBuilder(settings);
    SettingNames.Check(builder.Configuration, settings);
    builder.Logging.AddLines();
    MetricsExport.AddTo(builder.Services, builder.Configuration);   // before the managers, so it stops after them
    using var diagnostics = onlyChecks ? null : RabitDiagnostics.Open();   // for the tool: rabit top
    builder.Services.AddRabitUav(builder.Configuration, uav =>
    {
        uav.AddSimulation(builder.Configuration);
        uav.Setup((_, reactor) => diagnostics?.Add(reactor));
    });
    builder.Services.AddHealthChecks().AddRabit().AddRabitUav();
    builder.Services.AddSingleton<IHealthCheckPublisher, HealthLog>();
    builder.Services.Configure<HealthCheckPublisherOptions>(o => o.Period = TimeSpan.FromSeconds(5));
    builder.Services.AddRabitSystemd();

    using IHost host = builder.Build();
    if (onlyChecks)
        return Messages.SettingsAreGood(host.Services);
    if (diagnostics?.Fault is { } fault)
        DiagnosticsLog.NotOpened(host.Services.GetRequiredService<ILogger<RabitDiagnostics>>(), fault);
    await host.RunAsync();   // until SIGTERM, Ctrl-C, or the end of the managers
    return Environment.ExitCode;   // theirs
}
catch (OperationCanceledException)
{
    return Messages.StoppedInItsStart();
}
catch (Exception e) when (Messages.FaultsOf(e) is { } faults)
{
    return Messages.Refuse(faults);
}
