using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Serves the parameters of one component (MAVLink guide, "Parameter Protocol"): lists at a pace, reads by name and
/// index, sets. No I/O, no clock: frames in, frames out, time as argument. One thread; nothing is allocated per frame
/// but the reason of a refusal.
/// </summary>
/// <remarks>
/// Every PARAM_SET of a known name is answered by the value that stands after it, which is the old one where it was
/// refused; the reason goes out as PARAM_ERROR and as STATUSTEXT. In the bytewise encoding a set with another type than
/// the parameter's is refused (as by PX4), in the C-cast encoding the type does not matter (as for ArduPilot). A second
/// station that asks for a list while one is under way does not start it over: it goes on from where it is until both
/// have everything.
/// </remarks>
/// <example>
/// <code>
/// var list = new MavlinkParameterList();
/// list.Add("RBT_SPEED", MavParamType.Real32, value: 6, min: 2, max: 12);
/// var server = new MavlinkParameterServer(new MavlinkSender(1, 191), list, MavlinkParameterEncoding.Bytewise);
///
/// // For every frame that arrives: server.Handle(frame, now). After that, and at server.NextDue at the latest:
/// static void Step(MavlinkParameterServer server, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (server.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
/// }
/// </code>
/// </example>
public sealed partial class MavlinkParameterServer
{
    // Of the reason of a refusal.
    private const int MaxTextChunks = 16;

    // What a list may be late before it is no longer caught up: a caller that comes seldom must not flood the link.
    private static readonly TimeSpan MaxLateness = TimeSpan.OfSeconds(0.1);

    private readonly MavlinkSender _sender;
    private readonly IMavlinkParameterStore _store;
    private readonly MavlinkParameterServerOptions _options;
    private readonly ParameterReply[] _replies;
    private readonly ParameterHasher? _hasher;
    private int _firstReply;
    private int _replyCount;
    private readonly MavlinkStatusTextSplitter _texts = new(MaxTextChunks);
    private bool _isTextStarted;

    // The list under way: what is sent next, and how many are still to be sent.
    private int _cursor;
    private int _left;
    private int _listCount;
    private TimeSpan _listDue;

    /// <summary>Makes a server.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures; it is who is asked.</param>
    /// <param name="store">The parameters.</param>
    /// <param name="encoding">How integers are packed; as the capabilities in our AUTOPILOT_VERSION say.</param>
    /// <param name="options">What it answers; null for the defaults.</param>
    /// <exception cref="ArgumentNullException">No sender, or no parameters.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A capacity or time is out of range.</exception>
    public MavlinkParameterServer(
        MavlinkSender sender, IMavlinkParameterStore store, MavlinkParameterEncoding encoding,
        MavlinkParameterServerOptions? options = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        _store = store ?? throw new ArgumentNullException(nameof(store));
        Encoding = encoding;
        _options = options ?? new MavlinkParameterServerOptions();
        if (_options.Capacity < 1)
            throw new ArgumentOutOfRangeException(nameof(options), _options.Capacity, "The capacity is at min 1.");
        if (_options.ListInterval <= TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(
                nameof(options), _options.ListInterval, "The interval of a list is above 0.");
        _replies = new ParameterReply[_options.Capacity];
        _hasher = _options.SendsHash ? new ParameterHasher(store, encoding, _options.IsVolatile) : null;
    }

    /// <summary>How integers are packed.</summary>
    public MavlinkParameterEncoding Encoding { get; }

    /// <summary>Whether a list is under way.</summary>
    public bool IsListing => _left > 0;

    /// <summary>Sets that were refused.</summary>
    public long Refusals { get; private set; }

    /// <summary>Reads and sets of parameters that there are none of.</summary>
    public long Unknowns { get; private set; }

    /// <summary>Answers that were not sent, since too many were waiting.</summary>
    public long Dropped { get; private set; }

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to
    /// wait for. A time in the past means at once.
    /// </summary>
    public TimeSpan NextDue => _replyCount > 0 ? TimeSpan.Zero : _left > 0 ? _listDue : TimeSpan.MaxValue;

    /// <summary>Sends a parameter unasked: one whose value has changed from this side.</summary>
    /// <param name="index">Of the parameter.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such index.</exception>
    public void Report(int index)
    {
        if (index < 0 || index >= _store.Count)
            throw new ArgumentOutOfRangeException(nameof(index), index, $"There are {_store.Count} parameters.");
        Enqueue(new ParameterReply { Is = ParameterReply.Kind.Value, Index = index });
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        while (_replyCount > 0)
        {
            ref ParameterReply reply = ref _replies[_firstReply];
            bool isWhole = TryCreate(ref reply, out frame);
            if (isWhole)
            {
                reply.Text = null;
                _firstReply = (_firstReply + 1) % _replies.Length;
                _replyCount--;
            }

            if (frame.Version != MavlinkVersion.None)
                return true;
        }

        frame = default;
        if (_left == 0 || now < _listDue)
            return false;
        return TryTakeListed(now, out frame);
    }

    private bool TryTakeListed(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        int count = _store.Count;
        if (count != _listCount)
            (_cursor, _left, _listCount) = (0, count, count);
        if (_left == 0)
            return false;
        frame = Value(_cursor, _cursor);
        _cursor = _cursor + 1 < count ? _cursor + 1 : 0;
        _left--;
        _listDue = (now - _listDue > MaxLateness ? now : _listDue) + _options.ListInterval;
        return true;
    }

    // Whether it needs no further frame.
    private bool TryCreate(ref ParameterReply reply, out MavlinkFrame frame)
    {
        frame = default;
        switch (reply.Is)
        {
            case ParameterReply.Kind.Value when reply.Index < _store.Count:
                bool hasIndex = reply.IsByIndex || !_options.OmitsIndex;
                frame = Value(reply.Index, hasIndex ? reply.Index : MavlinkParameter.NoIndex);
                return true;
            case ParameterReply.Kind.Hash:
                frame = Value(ParameterHasher.Name, MavParamType.Uint32, _hasher!.Compute(), MavlinkParameter.NoIndex);
                return true;
            case ParameterReply.Kind.Error:
                frame = _sender.Create(new ParamError
                {
                    TargetSystem = reply.Source.SystemId,
                    TargetComponent = reply.Source.ComponentId,
                    ParamId = reply.Name,
                    ParamIndex = (short)reply.Index,
                    Error = reply.Error,
                });
                return true;
            case ParameterReply.Kind.Text:
                return TakePart(reply.Text!, out frame);
            default:
                return true;
        }
    }

    private MavlinkFrame Value(int index, int sentIndex)
    {
        MavlinkParameterValue parameter = _store[index];
        uint bits = MavlinkParameter.EncodeNearest(parameter.Value, parameter.Type, Encoding);
        return Value(MavlinkParameter.Clean(parameter.Name), parameter.Type, bits, sentIndex);
    }

    private MavlinkFrame Value(Text16 name, MavParamType type, uint bits, int index) => _sender.Create(new ParamValue
    {
        ParamId = name,
        Value = MavlinkParameter.ToFloat(bits),
        ParamType = type,
        ParamCount = (ushort)_store.Count,
        ParamIndex = (ushort)index,
    });

    // Whether the text is over; then there is no part.
    private bool TakePart(string text, out MavlinkFrame frame)
    {
        if (!_isTextStarted)
            _texts.Start(MavSeverity.Warning, text);
        _isTextStarted = _texts.TryNext(out Statustext part);
        frame = _isTextStarted ? _sender.Create(part) : default;
        return !_isTextStarted;
    }
}
