using System;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using OpenTelemetry;
using OpenTelemetry.Exporter;
using OpenTelemetry.Metrics;
using OpenTelemetry.Resources;

namespace UavService;

/// <summary>
/// Sends the figures of all managers by OpenTelemetry while the host runs. Used by the thread that starts it.
/// </summary>
internal sealed class MetricsExport(MetricsSettings settings) : IHostedService, IDisposable
{
    // A collector that does not answer must not keep the service from its end.
    private const int MaxStopMilliseconds = 1_000;

    private MeterProvider? _provider;

    /// <summary>Adds it, where the configuration says where metrics go.</summary>
    /// <exception cref="SettingException">Its settings are wrong.</exception>
    public static void AddTo(IServiceCollection services, IConfiguration configuration)
    {
        MetricsSettings settings = MetricsSettings.Read(configuration);
        if (settings.Endpoint is null)
            return;
        services.AddSingleton(settings);
        services.AddHostedService<MetricsFaults>();
        services.AddHostedService<MetricsExport>();
    }

    public Task StartAsync(CancellationToken cancellationToken)
    {
        _provider = Sdk.CreateMeterProviderBuilder()
            .AddMeter("Rabit.Core")   // docs/concepts/hosting.md has its instruments
            .ConfigureResource(resource => resource.AddService("uav-service"))
            .AddOtlpExporter((exporter, reader) =>
            {
                exporter.Endpoint = new Uri(settings.Endpoint!);
                exporter.Protocol = OtlpExportProtocol.HttpProtobuf;
                exporter.TimeoutMilliseconds = (int)Math.Min(10_000, settings.Period.TotalMilliseconds);
                reader.PeriodicExportingMetricReaderOptions.ExportIntervalMilliseconds
                    = (int)settings.Period.TotalMilliseconds;
            })
            .Build();
        return Task.CompletedTask;
    }

    public Task StopAsync(CancellationToken cancellationToken)
    {
        _provider?.Shutdown(MaxStopMilliseconds);
        return Task.CompletedTask;
    }

    public void Dispose() => _provider?.Dispose();
}
