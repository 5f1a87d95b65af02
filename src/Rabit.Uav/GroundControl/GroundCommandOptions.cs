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

    internal GroundCommandOptions Copy() => new() { SystemIds = [.. SystemIds], OnlySigned = OnlySigned };
}
