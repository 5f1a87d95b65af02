using System;
using System.Linq;
using Rabit.Mavlink;

namespace Rabit.Uav.GroundControl;

/// <summary>Who may command the mission.</summary>
internal sealed class Authority(GroundCommandOptions options)
{
    /// <summary>A sender as text, for the log.</summary>
    public static string NameOf(MavlinkAddress source)
        => FormattableString.Invariant($"system {source.SystemId} component {source.ComponentId}");

    /// <summary>Why a sender may not; null where it may.</summary>
    public string? FindDenial(MavlinkAddress source, bool isSigned)
    {
        if (!options.SystemIds.Contains(source.SystemId))
            return "it may not command";
        return options.OnlySigned && !isSigned ? "it is not signed" : null;
    }
}
