using System;
using System.Collections.Generic;

namespace Rabit.Uav.GroundControl;

/// <summary>Who may command the mission by MAVLink.</summary>
public sealed class GroundCommandOptions
{
    /// <summary>The system ids of those who may.</summary>
    /// <value>The default is 255 alone, that of ground stations.</value>
    public IReadOnlyList<byte> SystemIds { get; set; } = [255];

    /// <summary>Whether a command must be signed, on a link that verifies signatures.</summary>
    /// <value>The default is false.</value>
    public bool OnlySigned { get; set; }

    /// <summary>
    /// Whether the autopilot's fence, once others have changed it, is offered as another area to search, made smaller
    /// by the margin in which the vehicle stops; its exclusion polygons are the keep-outs. As an area that is uploaded
    /// to us, it is taken over by the operator's next continue.
    /// </summary>
    /// <value>The default is false: a fence is there for other reasons too.</value>
    public bool OffersAutopilotFence { get; set; }

    internal GroundCommandOptions Copy() => new()
    {
        SystemIds = [.. SystemIds],
        OnlySigned = OnlySigned,
        OffersAutopilotFence = OffersAutopilotFence,
    };
}
