using System;
using Rabit.Mavlink.Signing;

namespace Rabit.Mavlink;

/// <summary>
/// Validates the signatures of received frames (MAVLink guide, "Message signing"): the signature must be that of the
/// key, and the frame must be later than all before it of its stream. One verifier for all links of a process, so that
/// a frame received by one cannot be replayed into another. Frames must come from a <see cref="MavlinkFrameReader"/>,
/// which has checked the checksum. Allocates nothing, fixed memory. One thread at a time, together with its clock.
/// </summary>
/// <example>
/// <code>
/// using MavlinkSigningKey key = MavlinkSigningKey.FromPassphrase("a long phrase");
/// var clock = new MavlinkSigningClock();
/// var verifier = new MavlinkVerifier(key, clock);
///
/// static void Receive(in MavlinkFrame frame, MavlinkVerifier verifier)
/// {
///     if (!verifier.Verify(frame).IsAccepted())
///         return;   // verifier.Counters has how often, and why
///     Console.WriteLine(frame.ToString());
/// }
/// </code>
/// </example>
public sealed class MavlinkVerifier
{
    /// <summary>
    /// How far the first frame of a stream may be behind our signing clock: one minute, in its ticks.
    /// </summary>
    public const long NewStreamTolerance = 60 * MavlinkSigningClock.TicksPerSecond;

    private readonly MavlinkSigningKey _key;
    private readonly MavlinkSigningClock _clock;
    private readonly MavlinkUnsignedRule _acceptUnsigned;
    private readonly ReplayTable _streams;

    /// <summary>Makes a verifier. There is none without a key.</summary>
    /// <param name="key">The secret; its owner disposes of it.</param>
    /// <param name="clock">
    /// Advanced by accepted frames. Advance it regularly, or old frames of new streams are accepted.
    /// </param>
    /// <param name="acceptUnsigned">Which unsigned frames pass; <see cref="RadioStatusOnly"/> where null.</param>
    /// <param name="maxStreams">
    /// How many streams (system, component, link id) it can remember, 1 to 65 536. Frames of others are rejected.
    /// </param>
    /// <exception cref="ArgumentNullException">No key or no clock.</exception>
    /// <exception cref="ArgumentOutOfRangeException">Room for less than one stream or for too many.</exception>
    public MavlinkVerifier(
        MavlinkSigningKey key, MavlinkSigningClock clock, MavlinkUnsignedRule? acceptUnsigned = null,
        int maxStreams = 1024)
    {
        _key = key ?? throw new ArgumentNullException(nameof(key));
        _clock = clock ?? throw new ArgumentNullException(nameof(clock));
        if (maxStreams is < 1 or > 65_536)
            throw new ArgumentOutOfRangeException(
                nameof(maxStreams), maxStreams, "A verifier remembers 1 to 65536 streams.");
        _acceptUnsigned = acceptUnsigned ?? RadioStatusOnly;
        _streams = new ReplayTable(maxStreams);
    }

    /// <summary>The results so far.</summary>
    public MavlinkSignatureCounters Counters { get; private set; }

    /// <summary>How many streams it remembers.</summary>
    public int Streams => _streams.Count;

    /// <summary>
    /// The usual rule for unsigned frames: RADIO_STATUS passes, which telemetry radios put into the stream without
    /// knowing the key, and nothing else.
    /// </summary>
    /// <param name="frame">The frame.</param>
    /// <param name="link">The link; not used here.</param>
    /// <returns>Whether it is RADIO_STATUS.</returns>
    public static bool RadioStatusOnly(in MavlinkFrame frame, int link)
        => frame.MessageId == Messages.RadioStatus.MavlinkId;

    /// <summary>
    /// Validates one frame, in the order of arrival. Only an accepted frame changes what the verifier and its clock
    /// remember.
    /// </summary>
    /// <param name="frame">The frame.</param>
    /// <param name="link">The number of the link it came from, for the rule for unsigned frames.</param>
    /// <returns>The result.</returns>
    /// <exception cref="ObjectDisposedException">The key was disposed of.</exception>
    public MavlinkSignatureResult Verify(in MavlinkFrame frame, int link = 0)
    {
        MavlinkSignatureResult result = frame.IsSigned ? VerifySigned(frame)
            : frame.Version != MavlinkVersion.None
                && _acceptUnsigned(frame, link) ? MavlinkSignatureResult.UnsignedAllowed
            : MavlinkSignatureResult.NotSigned;
        Counters = Counters.With(result);
        return result;
    }

    // The signature first: an unproved frame may change nothing.
    private MavlinkSignatureResult VerifySigned(in MavlinkFrame frame)
    {
        if (!_key.Matches(frame))
            return MavlinkSignatureResult.BadSignature;

        long timestamp = frame.SignatureTimestamp;
        int stream = ReplayTable.StreamOf(frame.SystemId, frame.ComponentId, frame.SignatureLinkId);
        long newest = _streams.Find(stream, out int place);
        if (newest >= timestamp)
            return MavlinkSignatureResult.OldTimestamp;
        if (newest < 0)
        {
            if (timestamp < _clock.Timestamp - NewStreamTolerance)
                return MavlinkSignatureResult.NewStreamTooOld;
            if (_streams.IsFull)
                return MavlinkSignatureResult.TooManyStreams;
        }

        _streams.Set(place, stream, timestamp);
        _clock.Accept(timestamp);
        return newest < 0 ? MavlinkSignatureResult.ValidNewStream : MavlinkSignatureResult.Valid;
    }
}
