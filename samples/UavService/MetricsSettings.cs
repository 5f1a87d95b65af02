using System;
using Microsoft.Extensions.Configuration;

namespace UavService;

/// <summary>The section "Metrics" of the configuration.</summary>
internal sealed class MetricsSettings
{
    public const string Section = "Metrics";

    /// <summary>
    /// Where a collector takes metrics by OTLP over HTTP, as http://127.0.0.1:4318/v1/metrics; null to send none.
    /// </summary>
    public string? Endpoint { get; set; }

    /// <summary>How often they are sent.</summary>
    public TimeSpan Period { get; set; } = TimeSpan.FromSeconds(10);

    /// <exception cref="SettingException">A setting is not known, or its value cannot be.</exception>
    public static MetricsSettings Read(IConfiguration configuration)
    {
        var settings = SettingSection.Read<MetricsSettings>(configuration, Section);
        if (settings.Endpoint is { } endpoint
            && !(Uri.TryCreate(endpoint, UriKind.Absolute, out Uri? uri) && uri.Scheme is "http" or "https"))
            throw new SettingException(
                [$"{Section}:{nameof(Endpoint)} is '{endpoint}'; it must be as http://127.0.0.1:4318/v1/metrics"]);
        return settings.Period >= TimeSpan.FromSeconds(1) && settings.Period <= TimeSpan.FromHours(1)
            ? settings
            : throw new SettingException(
                [$"{Section}:{nameof(Period)} is {settings.Period}; it must be 00:00:01 to 01:00:00"]);
    }
}
