using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using Rabit.Links;

namespace UavConsole;

/// <summary>The option of the configuration file.</summary>
internal static class ConfigArguments
{
    private static readonly Option<string> Config = new("--config")
    {
        Description = "Takes links, mission, camera, failsafes and the options of all managers from a configuration "
            + "file as services have it: JSON with a section Uav (docs/concepts/hosting.md). Options of the command "
            + "line count more. With Uav:MayCommand it flies, as with --fly.",
        HelpName = "FILE",
    };

    // All that the return of an abandoned vehicle needs: nothing else of the file may prevent it.
    private static readonly string[] OfLinks = ["Links", "SystemId", "Signing"];

    /// <summary>All of them.</summary>
    public static IEnumerable<Option> All => [Config];

    /// <summary>Reads the file that is given.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="replaced">Keys of the section Uav that options of the command line stand for.</param>
    /// <param name="links">Of the command line.</param>
    /// <param name="faults">Takes what is wrong with it.</param>
    /// <returns>Null where none is given, or it cannot be used.</returns>
    public static ConfigFile? Read(
        ParseResult result, IEnumerable<(Option Option, string Key)> replaced, IReadOnlyList<LinkUrl> links,
        List<string> faults)
    {
        if (result.GetValue(Config) is not { } path)
            return null;
        string[] without = replaced.Where(r => result.GetResult(r.Option) is { Implicit: false })
            .Select(r => r.Key).ToArray();
        bool isOnlyForLinks = AbandonedArguments.Read(result) is not null;
        return ConfigFile.Read(
            path,
            key => !Array.Exists(without, w => IsIn(key, w))
                && (!isOnlyForLinks || Array.Exists(OfLinks, o => IsIn(key, o))),
            links,
            faults);
    }

    private static bool IsIn(string key, string part)
        => string.Equals(key, part, StringComparison.OrdinalIgnoreCase)
            || key.StartsWith(part + ":", StringComparison.OrdinalIgnoreCase);
}
