using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>Something that goes wrong at a set time. A plain value.</summary>
/// <example>
/// <code>
/// var silence = new ScriptedFault
/// {
///     Kind = ScriptedFaultKind.LinkSilent,
///     At = TimeSpan.FromSeconds(60),
///     Duration = TimeSpan.FromSeconds(10),
/// };
/// </code>
/// </example>
public struct ScriptedFault
{
    /// <summary>What.</summary>
    public ScriptedFaultKind Kind { get; set; }

    /// <summary>When it begins, by the clock of the run.</summary>
    public TimeSpan At { get; set; }

    /// <summary>How long it lasts, where it ends again.</summary>
    public TimeSpan Duration { get; set; }

    /// <summary>What it is about; see <see cref="ScriptedFaultKind"/>.</summary>
    public double Value { get; set; }

    /// <summary>The manager that it is about; see <see cref="ScriptedFaultKind.ManagerHangs"/>.</summary>
    public string? Manager { get; set; }

    /// <summary>
    /// The flight mode that a pilot takes, by the autopilot's own name, such as LOITER; null: by the number in
    /// <see cref="Value"/>. See <see cref="ScriptedFaultKind.PilotMode"/>.
    /// </summary>
    public string? Mode { get; set; }

    /// <summary>
    /// Whether the pilot takes the mode by the switch of the remote control, on which the autopilot acts a little
    /// later, instead of by a command.
    /// </summary>
    public bool BySwitch { get; set; }

    /// <summary>
    /// Where another commander wants the vehicle, metres in the frame of the world (from home, down negative above
    /// it); null: nowhere, it is to stop. See <see cref="ScriptedFaultKind.OtherCommander"/>.
    /// </summary>
    public NedPosition? Place { get; set; }

    /// <summary>
    /// Whether it is on at a time: from its beginning to before its end, or to the end of the run where its kind
    /// says so of a duration of zero.
    /// </summary>
    /// <param name="time">By the clock of the run.</param>
    public readonly bool IsOn(TimeSpan time)
        => time >= At && (time - At < Duration || (Duration == TimeSpan.Zero && LastsToTheEnd(Kind)));

    private static bool LastsToTheEnd(ScriptedFaultKind kind)
        => kind is ScriptedFaultKind.GroundStationSilent or ScriptedFaultKind.RcLost or ScriptedFaultKind.GpsLost
            or ScriptedFaultKind.GpsGlitch or ScriptedFaultKind.BatteryVolts or ScriptedFaultKind.EkfFailsafe
            or ScriptedFaultKind.ComputerHot or ScriptedFaultKind.ComputerUnderVoltage or ScriptedFaultKind.DiskLow
            or ScriptedFaultKind.FixNotReported or ScriptedFaultKind.PositionZero or ScriptedFaultKind.PositionFrozen
            or ScriptedFaultKind.PositionJump or ScriptedFaultKind.EstimatorRatio or ScriptedFaultKind.BatteryUnknown
            or ScriptedFaultKind.AttitudeSilent or ScriptedFaultKind.LinkDelayed
            || PictureFaults.IsOfPictures(kind);
}
