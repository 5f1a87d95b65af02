using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>All that is told at the end of a run, gathered from where it was counted.</summary>
internal sealed class RunSummary(UavSystem uav, ReactorResult result, HealthReport health, IReadOnlyList<LinkStatus> linkStatus)
{
    public FlightSummary Flight { get; } = uav.Autopilot.Flight;

    public IReadOnlyList<LinkSummary> Links { get; } = uav.Communications.SummariseLinks();

    /// <summary>As last told by Communications; in the order of <see cref="Links"/>.</summary>
    public IReadOnlyList<LinkStatus> LinkStatus { get; } = linkStatus;

    /// <summary>Frames of our own, counted apart from what came in.</summary>
    public IReadOnlyList<FrameCount> OwnFrames { get; } = uav.Communications.CountOwnFrames();

    public HealthReport Health { get; } = health;

    public ReactorResult Result { get; } = result;

    /// <summary>A replay that lost a frame has failed: it would not show the flight as it was.</summary>
    public bool HasReplayLostFrames { get; } = linkStatus.Any(l => !double.IsNaN(l.Progress) && (l.FramesDroppedIn > 0 || l.State == LinkState.Failed));

    public int ExitCode => HasReplayLostFrames ? 1 : Result.ExitCode;
}
