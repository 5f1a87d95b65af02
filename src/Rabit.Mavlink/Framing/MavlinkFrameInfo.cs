namespace Rabit.Mavlink;

/// <summary>What a <see cref="MavlinkFrameReader"/> found out about a frame beside its bytes. A plain value.</summary>
public readonly struct MavlinkFrameInfo
{
    internal MavlinkFrameInfo(long streamOffset, bool isChecked, in MavlinkMessageInfo message)
    {
        StreamOffset = streamOffset;
        IsChecked = isChecked;
        Message = message;
    }

    /// <summary>Where the frame began: bytes since the reader was made. For logs and diagnostics.</summary>
    public long StreamOffset { get; }

    /// <summary>
    /// Whether the dialect knows the id, so that the checksum was checked and is right. A frame that is not checked may
    /// be forwarded, nothing more: neither its content nor its source is certain.
    /// </summary>
    public bool IsChecked { get; }

    /// <summary>The description of the message; <c>default</c> where the id is unknown.</summary>
    public MavlinkMessageInfo Message { get; }
}
