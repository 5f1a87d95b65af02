using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Microsoft.Extensions.Configuration;

namespace Rabit.Hosting;

/// <summary>
/// Reads the options of a reactor from a section of the configuration, key by key: what cannot be read and what is not
/// known is named with its key. Needs no reflection, so it survives trimming.
/// </summary>
internal static class OptionsReader
{
    private static readonly string[] Keys =
    [
        nameof(RabitHostOptions.LogRuns), nameof(RabitHostOptions.KeepsStatistics),
        nameof(RabitHostOptions.MaxStopDelay), nameof(RabitHostOptions.StopTimeout),
        nameof(RabitHostOptions.TotalStopTimeout), nameof(RabitHostOptions.UnitOfWorkLimit),
        nameof(RabitHostOptions.StopsOnHang),
    ];

    /// <param name="section">That of the reactor.</param>
    /// <param name="names">Of all reactors: their sections are no settings of this one.</param>
    /// <param name="options">Takes what the section says.</param>
    /// <param name="faults">Takes a line for each setting that is wrong.</param>
    public static void Read(
        IConfigurationSection section, IEnumerable<string> names, RabitHostOptions options, List<string> faults)
    {
        foreach (IConfigurationSection setting in section.GetChildren())
        {
            string? key = Array.Find(Keys, k => string.Equals(k, setting.Key, StringComparison.OrdinalIgnoreCase));
            if (key is not null)
                Set(options, key, setting, faults);
            else if (!names.Contains(setting.Key, StringComparer.OrdinalIgnoreCase))
                faults.Add($"{setting.Path} is not known; there are: {string.Join(", ", Keys)}");
        }
    }

    private static void Set(RabitHostOptions options, string key, IConfigurationSection setting, List<string> faults)
    {
        switch (key)
        {
            case nameof(RabitHostOptions.LogRuns):
                options.LogRuns = Flag(setting, faults) ?? options.LogRuns;
                break;
            case nameof(RabitHostOptions.KeepsStatistics):
                options.KeepsStatistics = Flag(setting, faults) ?? options.KeepsStatistics;
                break;
            case nameof(RabitHostOptions.StopsOnHang):
                options.StopsOnHang = Flag(setting, faults) ?? options.StopsOnHang;
                break;
            case nameof(RabitHostOptions.MaxStopDelay):
                options.MaxStopDelay = Time(setting, faults) ?? options.MaxStopDelay;
                break;
            case nameof(RabitHostOptions.StopTimeout):
                options.StopTimeout = Time(setting, faults) ?? options.StopTimeout;
                break;
            case nameof(RabitHostOptions.TotalStopTimeout):
                options.TotalStopTimeout = Time(setting, faults) ?? options.TotalStopTimeout;
                break;
            default:
                options.UnitOfWorkLimit = Time(setting, faults) ?? options.UnitOfWorkLimit;
                break;
        }
    }

    private static bool? Flag(IConfigurationSection setting, List<string> faults)
    {
        if (bool.TryParse(setting.Value, out bool value))
            return value;
        faults.Add($"{setting.Path} is '{setting.Value}'; it must be true or false");
        return null;
    }

    private static TimeSpan? Time(IConfigurationSection setting, List<string> faults)
    {
        // "5" would be five days.
        if (setting.Value?.Any(c => c == ':') == true
            && TimeSpan.TryParse(setting.Value, CultureInfo.InvariantCulture, out TimeSpan value))
            return value;
        faults.Add($"{setting.Path} is '{setting.Value}'; it must be a time, as 00:00:02.5");
        return null;
    }
}
