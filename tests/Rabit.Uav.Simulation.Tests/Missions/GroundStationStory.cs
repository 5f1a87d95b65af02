using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>
/// A ground station of its own that commands a search in flight, one thing after the other, and checks each answer: it
/// has only frames and the log of the flight. It asks for nothing that our own clients do.
/// </summary>
/// <param name="write">Sends the bytes of a frame.</param>
/// <param name="read">Takes the frames that have come.</param>
/// <param name="step">Lets the flight go on for a tenth of a second; false where it has ended.</param>
/// <param name="log">The log of the flight so far.</param>
internal sealed class GroundStationStory(
    Action<byte[]> write, Func<IEnumerable<MavlinkFrame>> read, Func<bool> step, Func<string> log)
{
    private const byte Station = 255;
    private const byte Vehicle = 1;
    private const byte Computer = 191;
    private const int MaxSteps = 4000;

    private static readonly (double Latitude, double Longitude)[] Area =
        [(47.39730, 8.54470), (47.39790, 8.54470), (47.39790, 8.54580), (47.39730, 8.54580)];

    private static readonly (double Latitude, double Longitude)[] KeepOut =
        [(47.39768, 8.54555), (47.39768, 8.54572), (47.39780, 8.54572), (47.39780, 8.54555)];

    private readonly List<MavlinkFrame> _received = [];
    private readonly StringBuilder _text = new();
    private byte _sequence;
    private int _steps;

    /// <summary>What was asked, and what was answered.</summary>
    public List<string> Answers { get; } = [];

    /// <summary>All texts of our component.</summary>
    public List<string> Texts { get; } = [];

    public void Play()
    {
        WaitForLog("-> Searching");
        Assert.Equal(MavResult.Accepted, Command(MavCmd.DoPauseContinue, 0));
        Assert.Equal(3, Set("RBT_SPEED", 3));
        Assert.Equal(18, Set("RBT_SPACING", 18));
        Assert.Equal(18, Set("RBT_SPACING", 190));
        WaitForText("RBT_SPACING: fenceMarginMetres");
        Assert.Equal(MavResult.Accepted, Command(MavCmd.DoPauseContinue, 1));
        WaitForLog("at the first lane", times: 2);

        Assert.Equal(MavMissionResult.Invalid, Upload([Area[0], Area[2], Area[1], Area[3]], null));
        WaitForText("area refused");
        Assert.Equal(MavMissionResult.Accepted, Upload(Area, KeepOut));
        WaitForText("area offered");
        Assert.Equal(MavResult.Accepted, Command(MavCmd.DoPauseContinue, 1));
        WaitForLog("new area of 4 corners with 1 keep-outs");

        int target = WaitForTarget();
        Assert.Equal(MavResult.Accepted, Command(MavCmd.User1, 4, target));
        Assert.Equal(MavResult.Failed, Command(MavCmd.User1, 2, target));
        WaitForText("was rejected");
        Assert.Equal(MavResult.Accepted, Command(MavCmd.DoPauseContinue, 0));
        Assert.Equal(MavResult.Accepted, Revisit(47.39760, 8.54500));
        WaitForLog("-> Revisiting: ");
        WaitForLog("Revisiting -> Searching");
        Assert.Equal(MavResult.Unsupported, Command(MavCmd.DoSetServo, 1));
        Assert.Equal(MavResult.Accepted, Command(MavCmd.NavReturnToLaunch, 0));
        WaitForLog("-> Done");
        CheckLog();
    }

    // Each request of an operator is in the log, and so is its answer.
    private void CheckLog()
    {
        string all = log();
        int given = Count(all, "operator system 255 component 190: ");
        int answered = all.Split('\n').Count(l => l.Contains("operator system 255 component 190's ")
            && (l.Contains(" accepted") || l.Contains(" refused")));
        Assert.Equal(given, answered);
        Assert.InRange(given, 11, 20);
    }

    private MavResult Command(MavCmd command, float p1, float p2 = 0)
    {
        Send(new CommandLong
        {
            TargetSystem = Vehicle,
            TargetComponent = Computer,
            Command = command,
            Param1 = p1,
            Param2 = p2,
        });
        return Answer($"{command} {p1} {p2}", command);
    }

    private MavResult Revisit(double latitude, double longitude)
    {
        Send(new CommandInt
        {
            TargetSystem = Vehicle,
            TargetComponent = Computer,
            Command = MavCmd.DoSetRoiLocation,
            X = (int)Math.Round(latitude * 1e7),
            Y = (int)Math.Round(longitude * 1e7),
        });
        return Answer("revisit a place", MavCmd.DoSetRoiLocation);
    }

    private MavResult Answer(string asked, MavCmd command)
    {
        MavResult result = WaitFor<CommandAck>(a => a.Command == command && a.Result != MavResult.InProgress).Result;
        Answers.Add($"{asked}: {result}");
        return result;
    }

    private float Set(string name, float value)
    {
        Send(new ParamSet
        {
            TargetSystem = Vehicle,
            TargetComponent = Computer,
            ParamId = new Text16(name),
            ParamType = MavParamType.Real32,
            ParamValue = value,
        });
        float now = WaitFor<ParamValue>(v => v.ParamId.TextEquals(name)).Value;
        Answers.Add(FormattableString.Invariant($"{name} {value}: {now}"));
        return now;
    }

    private MavMissionResult Upload(
        (double Latitude, double Longitude)[] area, (double Latitude, double Longitude)[]? keepOut)
    {
        MissionItemInt[] items =
        [
            .. Corners(area, MavCmd.NavFencePolygonVertexInclusion, 0),
            .. Corners(keepOut ?? [], MavCmd.NavFencePolygonVertexExclusion, area.Length),
        ];
        Send(new MissionCount
        {
            TargetSystem = Vehicle,
            TargetComponent = Computer,
            MissionType = MavMissionType.Fence,
            Count = (ushort)items.Length,
        });
        MavMissionResult? result = null;
        for (int i = 0; i < MaxSteps && result is null; i++)
        {
            if (TryTake(a => a.MissionType == MavMissionType.Fence, out MissionAck ack))
                result = ack.Type;
            else if (TryTake(r => r.MissionType == MavMissionType.Fence, out MissionRequestInt request))
                Send(items[request.Seq]);
            else
                Step();
        }

        Answers.Add($"a fence of {items.Length} corners: {result}");
        return result ?? throw new TimeoutException("The upload got no answer.");
    }

    private static IEnumerable<MissionItemInt> Corners(
        (double Latitude, double Longitude)[] corners, MavCmd command, int first)
        => corners.Select((c, i) => new MissionItemInt
        {
            TargetSystem = Vehicle,
            TargetComponent = Computer,
            MissionType = MavMissionType.Fence,
            Command = command,
            Seq = (ushort)(first + i),
            Param1 = corners.Length,
            X = (int)Math.Round(c.Latitude * 1e7),
            Y = (int)Math.Round(c.Longitude * 1e7),
        });

    private int WaitForTarget()
    {
        WaitForText("Rabit: target ");
        string text = Texts.First(t => t.StartsWith("Rabit: target ", StringComparison.Ordinal));
        Answers.Add("seen: " + text);
        return int.Parse(text.Split(' ')[2], CultureInfo.InvariantCulture);
    }

    private void WaitForText(string part)
        => WaitUntil(() => Texts.Any(t => t.Contains(part)), part);

    private void WaitForLog(string part, int times = 1)
        => WaitUntil(() => Count(log(), part) >= times, part);

    private static int Count(string text, string part)
    {
        int count = 0;
        for (int at = text.IndexOf(part, StringComparison.Ordinal); at >= 0;
            at = text.IndexOf(part, at + 1, StringComparison.Ordinal))
            count++;
        return count;
    }

    private void WaitUntil(Func<bool> isDone, string what)
    {
        for (int i = 0; i < MaxSteps && !isDone(); i++)
        {
            if (!Step())
                break;
        }

        Assert.True(isDone(), $"'{what}' did not come");
    }

    private T WaitFor<T>(Func<T, bool> isMeant)
        where T : struct, IMavlinkMessage
    {
        for (int i = 0; i < MaxSteps; i++)
        {
            if (TryTake(isMeant, out T message))
                return message;
            Step();
        }

        throw new TimeoutException($"No {typeof(T).Name} came.");
    }

    private bool TryTake<T>(Func<T, bool> isMeant, out T message)
        where T : struct, IMavlinkMessage
    {
        for (int i = 0; i < _received.Count; i++)
        {
            if (!_received[i].TryDecode(out message) || !isMeant(message))
                continue;
            _received.RemoveAt(i);
            return true;
        }

        message = default;
        return false;
    }

    private bool Step()
    {
        // A second is ten steps.
        if (_steps++ % 10 == 0)
            Send(new Heartbeat { Type = MavType.Gcs, Autopilot = MavAutopilot.Invalid, MavlinkVersion = 3 });
        bool goesOn = step();
        foreach (MavlinkFrame frame in read())
        {
            if (frame.ComponentId != Computer)
                continue;
            if (frame.TryDecode(out Statustext text))
                Add(text);
            else if (frame.MessageId is CommandAck.MavlinkId or ParamValue.MavlinkId or MissionAck.MavlinkId
                or MissionRequestInt.MavlinkId)
                _received.Add(frame);
        }

        return goesOn;
    }

    private void Add(in Statustext text)
    {
        string part = text.Text.ToString();
        _text.Append(part);
        if (text.Id != 0 && part.Length == 50)
            return;
        Texts.Add(_text.ToString());
        _text.Clear();
    }

    private void Send<T>(T message)
        where T : struct, IMavlinkMessage
    {
        var bytes = new byte[MavlinkFrame.MaxWireLength];
        int length = MavlinkFrame.Create(message, Station, 190, _sequence++).WriteTo(bytes);
        Array.Resize(ref bytes, length);
        write(bytes);
    }
}
