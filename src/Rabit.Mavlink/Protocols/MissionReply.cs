using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Protocols;

/// <summary>An answer of a mission server that waits to be sent.</summary>
internal struct MissionReply
{
    public enum Kind
    {
        Count,
        Item,
        Ack,
        Current,
        Reached,
    }

    public Kind Is;
    public MavMissionType Type;
    public MavlinkAddress Target;
    public int Sequence;
    public MavMissionResult Result;
}
