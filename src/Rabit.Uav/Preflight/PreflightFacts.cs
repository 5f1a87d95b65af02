using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>What the rules of the checklist judge. One thread; filled again for each evaluation.</summary>
internal sealed class PreflightFacts(PreflightOptions options)
{
    public PreflightOptions Options { get; } = options;

    /// <summary>The ground that a return leads over; null where it is not known.</summary>
    public ReturnTerrain? ReturnTerrain { get; } = options.Terrain is { } terrain
        ? new ReturnTerrain(terrain, options.SearchArea, options.FenceMarginMetres)
        : null;

    public TimeSpan Now { get; set; }

    public VehicleState Vehicle { get; set; }

    public OwnAddress Own { get; set; }

    public NavigationStatus Navigation { get; set; }

    public AutopilotParameters Parameters { get; set; } = AutopilotParameters.None;

    /// <summary>The companion computer; unknown where it was not looked at of late.</summary>
    public ComputerStatus Computer { get; set; } = ComputerStatus.Unknown;

    public ImagingStatus Imaging { get; set; }

    /// <summary>Of all links.</summary>
    public long FramesIn { get; set; }

    /// <summary>Of all links.</summary>
    public long FramesMissing { get; set; }

    /// <summary>Whether something that was reported at a time is not older than so many seconds.</summary>
    public bool IsFresh(TimeSpan? time, double seconds) => Now - time <= TimeSpan.OfSeconds(seconds);
}
