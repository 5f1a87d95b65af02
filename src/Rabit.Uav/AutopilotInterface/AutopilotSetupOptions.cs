using System;
using System.Collections.Generic;
using Rabit.Geodesy;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Which of the autopilot's own parameters Autopilot Interface reads and writes before a flight. What it writes is
/// written back on the ground after it, also after a restart.
/// </summary>
public sealed class AutopilotSetupOptions
{
    /// <summary>
    /// Whether the parameters of the pre-flight checklist are read; set where there is a mission that needs it.
    /// </summary>
    /// <value>The default is false.</value>
    public bool ReadsParameters { get; set; }

    /// <summary>
    /// Whether parameters that do not pass are set to the values that the checklist wants (docs/preflight.md).
    /// </summary>
    /// <value>The default is false: nothing is written.</value>
    public bool SetsFailsafes { get; set; }

    /// <summary>
    /// Makes the autopilot's fence: the corners, in order, from the position of the vehicle on the ground. A fence that
    /// the autopilot has already is replaced, and restored after the flight. Called once, by the manager's thread.
    /// </summary>
    /// <value>The default is null: the autopilot's fence is not touched.</value>
    public Func<GeodeticPosition, IReadOnlyList<GeodeticPosition>>? Fence { get; set; }

    /// <summary>The polygons that the fence excludes, in order; they are uploaded with it.</summary>
    /// <value>The default is empty.</value>
    public IReadOnlyList<IReadOnlyList<GeodeticPosition>> KeepOuts { get; set; } = [];

    /// <summary>
    /// The file that keeps the autopilot's own values and fence from before the first write until they are written
    /// back. Needed where something is to be written; where it exists at the start, it is written back.
    /// </summary>
    /// <value>The default is null.</value>
    public string? OriginalsFile { get; set; }

    internal bool Writes => SetsFailsafes || Fence is not null;

    internal AutopilotSetupOptions Copy() => (AutopilotSetupOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (Writes && string.IsNullOrWhiteSpace(OriginalsFile))
            yield return $"{nameof(OriginalsFile)} is needed: the autopilot's own values are kept there before "
                + "anything is written";
    }
}
