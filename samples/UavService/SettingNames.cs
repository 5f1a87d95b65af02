using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.Configuration.CommandLine;
using Microsoft.Extensions.Configuration.Json;

namespace UavService;

/// <summary>
/// Finds what the configuration would pass over in silence: sections and arguments that are not known.
/// </summary>
internal static class SettingNames
{
    private const string Vehicle = "Uav";

    private static readonly string[] Sections
        = [SimulationSettings.Section, Vehicle, "Rabit", MetricsSettings.Section, "Logging"];

    // Of the host itself.
    private static readonly string[] OfTheHost
        = ["contentRoot", "environment", "applicationName", "shutdownTimeoutSeconds"];

    /// <exception cref="SettingException">Some are not known; all of them are named.</exception>
    public static void Check(IConfigurationRoot configuration, string[] arguments)
    {
        var faults = new List<string>();
        foreach (IConfigurationProvider provider in configuration.Providers)
        {
            string? source = provider switch
            {
                JsonConfigurationProvider file => file.Source.Path,
                CommandLineConfigurationProvider => "the command line",
                _ => null,   // the environment is full of other things
            };
            if (source is not null)
                faults.AddRange(Unknown(provider).Select(
                    name => $"{name} of {source} is not known; there are: {string.Join(", ", Sections)}"));
        }

        faults.AddRange(Stray(arguments).Select(
            a => $"{a} of the command line is not known; a setting is given as --Uav:SystemId 7"));
        if (faults.Count == 0 && !configuration.GetSection(Vehicle).Exists()
            && !configuration.GetSection(SimulationSettings.Section).Exists())
            faults.Add($"there are no settings: no {Path.GetFullPath("appsettings.json")}");
        if (faults.Count > 0)
            throw new SettingException(faults.Distinct(StringComparer.Ordinal).ToArray());
    }

    private static IEnumerable<string> Unknown(IConfigurationProvider provider)
        => provider.GetChildKeys([], parentPath: null).Distinct(StringComparer.OrdinalIgnoreCase)
            .Where(k => !Sections.Concat(OfTheHost).Contains(k, StringComparer.OrdinalIgnoreCase));

    // What is neither --NAME=VALUE nor --NAME VALUE.
    private static IEnumerable<string> Stray(string[] arguments)
    {
        for (int i = 0; i < arguments.Length; i++)
        {
            bool isName = arguments[i].StartsWith("--", StringComparison.Ordinal);
            bool isWhole = isName && arguments[i].Contains('=', StringComparison.Ordinal);
            if (!isName || (!isWhole && i == arguments.Length - 1))
                yield return arguments[i];
            else if (!isWhole)
                i++;
        }
    }
}
