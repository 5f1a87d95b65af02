using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// A message of another vehicle, as far as it has come; remembered for a while when it is whole. One thread.
/// </summary>
internal sealed class IncomingExchange(in ExchangeFragment first, TimeSpan now)
{
    // A message may be whole in one of several copies that are still on their way when its life ends.
    private static readonly TimeSpan Memory = TimeSpan.FromSeconds(30);

    private byte[]? _content = new byte[first.Count * ExchangeWire.FragmentLength];
    private int _lastLength;

    public ExchangeFragment Header { get; } = first;

    public TimeSpan Deadline { get; } = now + TimeSpan.FromTicks(first.LifetimeMs * TimeSpan.TicksPerMillisecond);

    public TimeSpan ForgottenAt => Deadline + Memory;

    public uint Fragments { get; private set; }

    public bool IsWhole => Fragments == (Header.Count == 32 ? uint.MaxValue : (1u << Header.Count) - 1);

    /// <summary>Whether it was handed on, or is not to be: it waits for nothing.</summary>
    public bool IsOver { get; private set; }

    public bool IsUnderstood { get; set; } = true;

    /// <summary>When an acknowledgement is due; null while none is.</summary>
    public TimeSpan? AcknowledgementDue { get; set; }

    public bool IsRelayed { get; set; }

    /// <summary>When it was posted: of the fragments the one that was least on the way says it best.</summary>
    public TimeSpan PostedTime { get; private set; } = TimeSpan.MaxValue;

    public void NoteAge(int ageMs, TimeSpan receivedTime)
    {
        TimeSpan posted = receivedTime - TimeSpan.FromTicks(ageMs * TimeSpan.TicksPerMillisecond);
        if (posted < PostedTime)
            PostedTime = posted;
    }

    /// <summary>Whether a fragment says the same of the message as the first one did.</summary>
    public bool Fits(in ExchangeFragment other)
        => other.Count == Header.Count && other.Type == Header.Type && other.TypeVersion == Header.TypeVersion
            && other.Destination == Header.Destination;

    /// <returns>False where it had come already.</returns>
    public bool Add(int index, ReadOnlySpan<byte> content)
    {
        uint bit = 1u << index;
        if ((Fragments & bit) != 0)
            return false;
        Fragments |= bit;
        content.CopyTo(_content.AsSpan(index * ExchangeWire.FragmentLength));
        if (index == Header.Count - 1)
            _lastLength = content.Length;
        return true;
    }

    /// <summary>Gives up what it holds; the rest is remembered.</summary>
    public byte[] TakeContent()
    {
        byte[] content = _content ?? [];
        int length = ((Header.Count - 1) * ExchangeWire.FragmentLength) + _lastLength;
        End();
        Array.Resize(ref content, length);
        return content;
    }

    public void End() => (_content, IsOver) = (null, true);
}
