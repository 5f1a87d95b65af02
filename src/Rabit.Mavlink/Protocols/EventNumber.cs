namespace Rabit.Mavlink.Protocols;

/// <summary>The numbers that arguments of events are packed as.</summary>
internal enum EventNumber
{
    UInt8,
    Int8,
    UInt16,
    Int16,
    UInt32,
    Int32,
    UInt64,
    Int64,
    Single,
}
