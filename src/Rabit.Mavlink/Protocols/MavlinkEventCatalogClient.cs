using System;
using System.Globalization;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Fetches the texts of a component's events from the component itself (MAVLink guide, "Component Metadata Protocol"):
/// asks for COMPONENT_METADATA, reads the file that it names by MAVLink FTP, and the file of events that that one
/// names. No I/O, no clock: frames in, frames out, time as argument. One thread.
/// </summary>
/// <remarks>
/// Files that are compressed with xz, as those of PX4's own builds are, are not unpacked: <see cref="Failure"/> says
/// so. Nor is anything fetched from the Internet.
/// </remarks>
/// <example>
/// <code>
/// var fetch = new MavlinkEventCatalogClient(new MavlinkSender(255, 190), new MavlinkAddress(1, 1));
/// fetch.Start(now: TimeSpan.Zero);
///
/// // For every frame that arrives: fetch.Handle(frame, now). After that, and at fetch.NextDue at the latest:
/// static void Step(MavlinkEventCatalogClient fetch, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (fetch.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
///     if (!fetch.IsBusy)
///         Console.WriteLine(fetch.Failure ?? $"{fetch.Catalog!.Count} events");
/// }
/// </code>
/// </example>
public sealed class MavlinkEventCatalogClient
{
    private const int MaxRequests = 3;
    private const int EventsType = (int)CompMetadataType.Events;
    private const string Scheme = "mftp://";
    private const string Component = "[;comp=";

    private static readonly TimeSpan AnswerTimeout = TimeSpan.FromSeconds(1);

    private readonly MavlinkSender _sender;
    private readonly MavlinkAddress _target;
    private MavlinkFtpClient? _files;
    private Step _step;
    private int _requests;
    private TimeSpan _due;

    /// <summary>Makes a client.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="target">Whose events.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentException">The target is not one component.</exception>
    public MavlinkEventCatalogClient(MavlinkSender sender, MavlinkAddress target)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        if (target.SystemId == 0 || target.ComponentId == 0)
            throw new ArgumentException("Metadata are those of one component; 0 means all.", nameof(target));
        _target = target;
    }

    private enum Step
    {
        Idle,
        Address,
        General,
        Events,
    }

    /// <summary>Whether it is under way.</summary>
    public bool IsBusy => _step != Step.Idle;

    /// <summary>What was fetched; null before that.</summary>
    public MavlinkEventCatalog? Catalog { get; private set; }

    /// <summary>Why nothing was fetched, for people; null while it is under way, and where it was.</summary>
    public string? Failure { get; private set; }

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while nothing is under
    /// way.
    /// </summary>
    public TimeSpan NextDue => _step switch
    {
        Step.Idle => TimeSpan.MaxValue,
        Step.Address => _due,
        _ => _files!.NextDue,
    };

    /// <summary>Begins, or begins again.</summary>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Start(TimeSpan now)
    {
        (_step, _requests, _due, Failure) = (Step.Address, 0, now, null);
        _files?.Cancel(now);
    }

    /// <summary>Handles a received frame; all but the metadata and the files of the component are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (_step == Step.Address && frame.MessageId == ComponentMetadata.MavlinkId && _target.IsSourceOf(frame)
            && frame.TryDecode(out ComponentMetadata metadata))
            Read(Step.General, metadata.Uri.ToString(), now);
        if (_step is not (Step.General or Step.Events))
            return;
        _files!.Handle(frame, now);
        TakeOutcome(now);
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        if (_step is Step.General or Step.Events)
        {
            bool hasFrame = _files!.TryTakeFrame(now, out frame);
            TakeOutcome(now);
            return hasFrame;
        }

        if (_step != Step.Address || now < _due)
            return false;
        if (_requests++ >= MaxRequests)
        {
            Fail("the autopilot does not say where its metadata are");
            return false;
        }

        _due = now + AnswerTimeout;
        frame = _sender.Create(new CommandLong
        {
            TargetSystem = _target.SystemId,
            TargetComponent = _target.ComponentId,
            Command = MavCmd.RequestMessage,
            Param1 = ComponentMetadata.MavlinkId,
        });
        return true;
    }

    private void TakeOutcome(TimeSpan now)
    {
        if (_step == Step.Idle || !_files!.TryTakeOutcome(out MavlinkFtpOutcome outcome))
            return;
        string what = _step == Step.General ? "metadata" : "file of events";
        if (outcome.Status != MavlinkFtpStatus.Done)
            Fail($"the autopilot's {what} cannot be read: {outcome.Status}");
        else if (MavlinkEventCatalog.IsCompressed(_files.Content.Span))
            Fail($"the autopilot's {what} is compressed with xz");
        else
            TakeFile(now);
    }

    private void TakeFile(TimeSpan now)
    {
        try
        {
            if (_step == Step.Events)
            {
                Catalog = MavlinkEventCatalog.Parse(_files!.Content);
                _step = Step.Idle;
            }
            else if (AddressOfEvents(_files!.Content) is { } address)
            {
                Read(Step.Events, address, now);
            }
            else
            {
                Fail("the autopilot's metadata name no file of events");
            }
        }
        catch (Exception e) when (e is FormatException or JsonException or InvalidOperationException)
        {
            Fail("the autopilot's metadata: " + e.Message);
        }
    }

    private static string? AddressOfEvents(ReadOnlyMemory<byte> json)
    {
        using var document = JsonDocument.Parse(json);
        if (document.RootElement.ValueKind != JsonValueKind.Object
            || !document.RootElement.TryGetProperty("metadataTypes", out JsonElement types)
            || types.ValueKind != JsonValueKind.Array)
            return null;
        foreach (JsonElement type in types.EnumerateArray())
        {
            if (type.ValueKind == JsonValueKind.Object && type.TryGetProperty("type", out JsonElement number)
                && number.ValueKind == JsonValueKind.Number && number.TryGetInt32(out int kind) && kind == EventsType
                && type.TryGetProperty("uri", out JsonElement address) && address.ValueKind == JsonValueKind.String)
                return address.GetString();
        }

        return null;
    }

    // mftp://[;comp=1]path: files of that component; of the one that says it where none is named.
    private void Read(Step step, string address, TimeSpan now)
    {
        if (!address.StartsWith(Scheme, StringComparison.Ordinal))
        {
            Fail($"the autopilot's metadata are at '{address}', which is no file of its own");
            return;
        }

        string path = address.Substring(Scheme.Length);
        byte component = _target.ComponentId;
        int close = path.IndexOf(']');
        if (path.StartsWith(Component, StringComparison.Ordinal) && close > 0)
        {
            string number = path.Substring(Component.Length, close - Component.Length);
            if (byte.TryParse(number, NumberStyles.None, CultureInfo.InvariantCulture, out byte named) && named != 0)
                (component, path) = (named, path.Substring(close + 1));
        }

        _files = new MavlinkFtpClient(_sender, new MavlinkAddress(_target.SystemId, component));
        _step = step;
        if (path.Length is 0 or > FtpPacket.MaxData || path.AsSpan().IndexOf('\0') >= 0
            || !_files.TryStartRead(path, now))
            Fail($"the autopilot's metadata are at '{address}', which is no file");
    }

    private void Fail(string why) => (_step, Failure) = (Step.Idle, why);
}
