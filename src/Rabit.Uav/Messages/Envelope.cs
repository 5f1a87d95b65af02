namespace Rabit.Uav.Messages;

/// <summary>
/// A typed message between vehicles: what one manager pushes here falls into the queue of the manager over there that
/// declared the type. A plain value if its content is one.
/// </summary>
/// <typeparam name="T">What is inside; Communications has a codec for each such type.</typeparam>
public struct Envelope<T>
{
    /// <summary>MAVLink system id of the vehicle that sent it; filled in by Communications.</summary>
    public byte SourceSystemId { get; set; }

    /// <summary>MAVLink system id of the vehicle that it is for; 0 for all.</summary>
    public byte TargetSystemId { get; set; }

    /// <summary>The content.</summary>
    public T Content { get; set; }
}
