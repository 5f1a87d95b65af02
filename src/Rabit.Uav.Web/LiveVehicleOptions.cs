using System;
using System.Collections.Generic;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Web;

/// <summary>What a <see cref="LivePage"/> shows of a vehicle. Read once, when it is added.</summary>
public sealed class LiveVehicleOptions
{
    /// <summary>What it is called on the page; null for "vehicle" with its number.</summary>
    /// <value>The default is null.</value>
    public string? Name { get; set; }

    /// <summary>How many links are shown: <see cref="UavSystem.LinkCount"/>.</summary>
    /// <value>The default is 0.</value>
    public int LinkCount { get; set; }

    /// <summary>
    /// Takes the operator's commands, as <see cref="UavSystem.MissionControl"/> does; null where nothing is commanded.
    /// </summary>
    /// <value>The default is null.</value>
    public IMissionOperator? Operator { get; set; }

    /// <summary>
    /// Returns the newest image chips, as <see cref="ImageProcessingManager.ImageChips"/> does; null for a page without
    /// pictures. Called by a thread of the page.
    /// </summary>
    /// <value>The default is null.</value>
    public Func<IReadOnlyList<ImageChip>>? ImageChips { get; set; }

    /// <summary>The log of the run; null for a page without one.</summary>
    /// <value>The default is null.</value>
    public LiveLog? Log { get; set; }

    /// <summary>
    /// Whether other vehicles that are received on the links are shown. Goes with
    /// <see cref="LivePage.CreateSubscription"/> in <see cref="UavOptions.Subscriptions"/>.
    /// </summary>
    /// <value>The default is false.</value>
    public bool ShowsOtherVehicles { get; set; }
}
