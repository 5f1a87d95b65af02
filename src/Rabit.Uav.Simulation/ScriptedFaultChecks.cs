using System;
using System.Collections.Generic;

namespace Rabit.Uav.Simulation;

/// <summary>What is wrong with scripted faults, in words.</summary>
internal static class ScriptedFaultChecks
{
    private const double MaxGlitchMetres = 10_000;
    private const double MaxVolts = 100;
    private const double MinCelsius = -55;
    private const double MaxCelsius = 150;

    // That of the simulated disk.
    private const double MaxDiskBytes = 32e9;
    private const double MaxBlurPixels = 50;
    private const double MaxSecondsOff = 1_000_000;
    private const double MaxRatio = 1000;
    private const double MaxDelaySeconds = 10;

    public static IEnumerable<string> FindFaults(SimulationOptions options)
    {
        if (options.Faults is null)
        {
            yield return $"{nameof(options.Faults)} is null; it may be empty";
            yield break;
        }

        foreach (ScriptedFault fault in options.Faults)
        {
            string what = FormattableString.Invariant($"{nameof(options.Faults)}: {fault.Kind} at {fault.At}");
            if (fault.At < TimeSpan.Zero || fault.Duration < TimeSpan.Zero)
                yield return what + " has a negative time";
            if (fault.Kind is ScriptedFaultKind.LinkSilent or ScriptedFaultKind.CameraFreeze
                or ScriptedFaultKind.ManagerHangs or ScriptedFaultKind.Gust
                && fault.Duration == TimeSpan.Zero)
                yield return what + " lasts no time";
            if (fault.Kind == ScriptedFaultKind.ManagerHangs && string.IsNullOrWhiteSpace(fault.Manager))
                yield return what + " names no manager";
            if (fault.Kind == ScriptedFaultKind.GroundStationSilent && !options.HasGroundStation)
                yield return what
                    + $" is about a ground station that is not there ({nameof(options.HasGroundStation)})";
            if (fault.Kind == ScriptedFaultKind.PilotMode && fault.Mode is { } mode)
            {
                if (!ModeNames.TryFind(options.Autopilot, mode, out _))
                    yield return $"{what} names the flight mode '{mode}', which the autopilot does not have";
            }
            else if (!IsPossible(fault, options.Autopilot))
            {
                yield return FormattableString.Invariant(
                    $"{what} has the value {fault.Value}, which is not possible");
            }
        }
    }

    /// <summary>The fault with the number of the flight mode that it names.</summary>
    public static ScriptedFault WithModeNumber(ScriptedFault fault, SimulatedAutopilot autopilot)
    {
        if (fault.Mode is { } name && ModeNames.TryFind(autopilot, name, out uint mode))
            fault.Value = mode;
        return fault;
    }

    private static bool IsPossible(in ScriptedFault fault, SimulatedAutopilot autopilot) => fault.Kind switch
    {
        ScriptedFaultKind.BatteryTo or ScriptedFaultKind.BatteryTrueTo => fault.Value is >= 0 and <= 1,
        ScriptedFaultKind.Gust => SimulationOptions.IsWind(fault.Value),
        ScriptedFaultKind.ComputerHot => fault.Value is >= MinCelsius and <= MaxCelsius,
        ScriptedFaultKind.DiskLow => fault.Value is >= 0 and <= MaxDiskBytes,
        ScriptedFaultKind.WindTo => SimulationOptions.IsWind(fault.Value),
        ScriptedFaultKind.PilotMode => fault.Value is >= 0 and <= uint.MaxValue
            && ModeNames.IsKnown(autopilot, (uint)fault.Value),
        ScriptedFaultKind.GpsGlitch or ScriptedFaultKind.PositionJump => Math.Abs(fault.Value) <= MaxGlitchMetres,
        ScriptedFaultKind.EstimatorRatio => fault.Value is >= 0 and <= MaxRatio,
        ScriptedFaultKind.BatteryVolts => fault.Value is >= 0 and <= MaxVolts,
        ScriptedFaultKind.Reboot or ScriptedFaultKind.BatteryUnknown => fault.Value is 0 or 1,
        ScriptedFaultKind.PicturesFrozen => fault.Value is 0 or 1,
        ScriptedFaultKind.PicturesDefocused => fault.Value is >= 0 and <= MaxBlurPixels,
        ScriptedFaultKind.PicturesMotionBlurred => fault.Value is >= 0 and <= MaxBlurPixels,
        ScriptedFaultKind.PicturesCovered => fault.Value is >= 0 and <= 1,
        ScriptedFaultKind.PictureTimesOff => Math.Abs(fault.Value) <= MaxSecondsOff,
        ScriptedFaultKind.TelemetryStale or ScriptedFaultKind.TimesyncWrong
            => Math.Abs(fault.Value) <= MaxSecondsOff,
        ScriptedFaultKind.LinkDelayed => fault.Value is >= 0 and <= MaxDelaySeconds,
        _ => true,
    };
}
