using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>A track and where it stands on the map. Immutable.</summary>
internal sealed class MapTrack(NedPosition position, TargetTrack track)
{
    /// <summary>In the frame of the map, metres.</summary>
    public NedPosition Position { get; } = position;

    public TargetTrack Track { get; } = track;
}
