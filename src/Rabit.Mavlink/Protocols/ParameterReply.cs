using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Protocols;

/// <summary>An answer of a parameter server that waits to be sent: a value, an error, or a part of a text.</summary>
internal struct ParameterReply
{
    public enum Kind
    {
        Value,
        Hash,
        Error,
        Text,
    }

    public Kind Is;

    /// <summary>Of a value, and of an error of a request by index; -1 of one by name.</summary>
    public int Index;

    /// <summary>Whether the request gave the index.</summary>
    public bool IsByIndex;

    public Text16 Name;
    public MavParamError Error;
    public MavlinkAddress Source;
    public string? Text;
}
