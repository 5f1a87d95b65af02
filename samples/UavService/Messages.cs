using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Options;
using Rabit.Core;
using Rabit.Hosting;
using Rabit.Uav;

namespace UavService;

/// <summary>What is said outside the log. Each returns the exit code that goes with it.</summary>
internal static class Messages
{
    private const int BadInput = 2;

    public static int Help()
    {
        Console.WriteLine(
            """
            UavService [--check] [--SETTING VALUE ...]

            The companion computer as a service. Its settings are in appsettings.json of the folder that it runs in, in
            the environment (Uav__SystemId=7) and on the command line (--Uav:SystemId 7); docs/concepts/hosting.md
            has all of them. --check only says whether they are good: nothing is opened or sent.
            """);
        return 0;
    }

    /// <summary>Reads all settings of the vehicle, and the files that they name.</summary>
    /// <exception cref="OptionsValidationException">Some are wrong.</exception>
    public static int SettingsAreGood(IServiceProvider services)
    {
        UavOptions options = services.GetRequiredService<IOptions<UavOptions>>().Value;
        string vehicle = options.Links.Count == 0
            ? "a simulated vehicle"
            : "a vehicle behind " + string.Join(", ", options.Links);
        Console.WriteLine(options.MayCommand && options.Mission is { } mission
            ? $"The settings are good: {vehicle} flies '{mission.Name}'."
            : $"The settings are good: {vehicle} is observed.");
        return 0;
    }

    /// <summary>SIGTERM before all managers had started: an end that was asked for.</summary>
    public static int StoppedInItsStart()
    {
        Console.WriteLine("UavService: stopped while it started");
        return 0;
    }

    /// <summary>What is wrong with the input, line by line; null where an exception says nothing of it.</summary>
    public static IReadOnlyList<string>? FaultsOf(Exception exception) => exception switch
    {
        SettingException e => e.Faults,
        RabitHostingException e => e.Faults,
        RabitWiringException e => e.Faults,
        OptionsValidationException e => e.Failures.ToArray(),
        InvalidDataException or FormatException => [WithCauses(exception)],
        _ => null,
    };

    public static int Refuse(IEnumerable<string> faults)
    {
        foreach (string fault in faults)
            Console.Error.WriteLine("UavService: " + fault);
        return BadInput;
    }

    // A file that is no JSON: which file, then where in it.
    private static string WithCauses(Exception exception)
    {
        var texts = new List<string>();
        for (Exception? e = exception; e is not null; e = e.InnerException)
            texts.Add(e.Message);
        return string.Join(" ", texts);
    }
}
