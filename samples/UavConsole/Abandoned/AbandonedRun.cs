using System;
using System.Globalization;
using System.IO;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav;
using Rabit.Uav.Communications;
using Rabit.Uav.MissionControl;

namespace UavConsole;

/// <summary>
/// The program after the program: whether a flight that ended by a fault left its vehicle hovering, and if so asks it
/// to return.
/// </summary>
internal static class AbandonedRun
{
    private const int NotDone = 1;
    private const int BadInput = 2;

    /// <inheritdoc cref="FlightRun.Run"/>
    public static int Run(ConsoleOptions options, TextWriter errors)
    {
        try
        {
            string? serviceResult = Environment.GetEnvironmentVariable("SERVICE_RESULT");
            if (FindReasonToStay(serviceResult, options.AbandonedStateFile!) is { } reason)
                return Report(reason + "; nothing is sent", exitCode: 0);
            using MavlinkSigningKey? key = options.SignKeyFile is { } file ? SigningKeyFile.Read(file) : null;
            return Ask(options, key);
        }
        catch (Exception e) when (e is LinkException or ArgumentException or PlatformNotSupportedException)
        {
            FaultLine.Write(errors, e.Message);
            return BadInput;
        }
    }

    /// <summary>Decides by what is known on this computer; before any link is opened.</summary>
    /// <param name="serviceResult">What systemd says of the service; null where it says nothing.</param>
    /// <param name="stateFile">The progress file of the flight.</param>
    /// <returns>Why the vehicle is left alone, as text; null where it is to be looked at.</returns>
    internal static string? FindReasonToStay(string? serviceResult, string stateFile)
    {
        if (string.IsNullOrEmpty(serviceResult))
            return "SERVICE_RESULT is not set: this is for ExecStopPost of a service";
        if (string.Equals(serviceResult, "success", StringComparison.Ordinal))
            return "the service ended in order";
        try
        {
            return MissionProgress.ReadFile(stateFile).IsCommanding
                ? null
                : $"{stateFile} does not say that the vehicle was commanded";
        }
        catch (Exception e) when (e is MissionProgressException or ArgumentException or NotSupportedException)
        {
            return e.Message.TrimEnd('.');
        }
    }

    private static int Ask(ConsoleOptions options, MavlinkSigningKey? key)
    {
        var manager = new AbandonedReturnManager();
        using UavSystem uav = UavSystem.Open(new UavOptions
        {
            Links = options.Links,
            SystemId = options.SystemId,
            OtherManagers = [manager],
            Signing = key is null ? null : Flight.SigningOf(key, options),
        });
        ReactorResult result = uav.CreateReactor(new ReactorOptions()).Run();
        return Report(manager.Outcome, result.ExitCode == 0 && manager.IsInOrder ? 0 : NotDone);
    }

    private static int Report(string outcome, int exitCode)
    {
        Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "return if abandoned: {0}", outcome));
        return exitCode;
    }
}
