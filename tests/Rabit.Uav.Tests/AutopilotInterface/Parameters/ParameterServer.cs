using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;

namespace Rabit.Uav.Tests.AutopilotInterface.Parameters;

/// <summary>
/// The parameter and fence protocol of an autopilot, as far as one peer needs it: an unknown name is not answered.
/// </summary>
internal sealed class ParameterServer(MavAutopilot make)
{
    private readonly MavlinkParameterEncoding _encoding = MavlinkParameter.EncodingOf(make);
    private readonly List<MissionItemInt> _upload = [];
    private int _expected;

    public Dictionary<string, (MavParamType Type, double Value)> Values { get; } = new(StringComparer.Ordinal);

    public List<MissionItemInt> Fence { get; set; } = [];

    /// <summary>Names that keep their value whatever is set.</summary>
    public HashSet<string> ReadOnly { get; } = new(StringComparer.Ordinal);

    public List<string> Reads { get; } = [];

    public List<(string Name, double Value)> Sets { get; } = [];

    public int Uploads { get; private set; }

    public int Clears { get; private set; }

    /// <summary>How many of the next frames are lost.</summary>
    public int Lost { get; set; }

    public IEnumerable<MavlinkFrame> Answer(MavlinkFrame frame)
    {
        if (Lost > 0)
        {
            Lost--;
            return [];
        }

        return frame.MessageId switch
        {
            ParamRequestRead.MavlinkId => Read(OutgoingSink.Decode<ParamRequestRead>(frame)),
            ParamSet.MavlinkId => Set(OutgoingSink.Decode<ParamSet>(frame)),
            MissionRequestList.MavlinkId => [Of(new MissionCount
            {
                TargetSystem = 1, TargetComponent = 191, Count = (ushort)Fence.Count,
                MissionType = MavMissionType.Fence,
            })],
            MissionRequestInt.MavlinkId => [Of(Fence[OutgoingSink.Decode<MissionRequestInt>(frame).Seq])],
            MissionCount.MavlinkId => Begin(OutgoingSink.Decode<MissionCount>(frame).Count),
            MissionItemInt.MavlinkId => Take(OutgoingSink.Decode<MissionItemInt>(frame)),
            MissionClearAll.MavlinkId => Clear(),
            _ => [],
        };
    }

    private static MavlinkFrame Of<T>(in T message)
        where T : struct, IMavlinkMessage => MavlinkFrame.Create(message, 1, 1, 0);

    private static MavlinkFrame Acknowledge(MavMissionResult result) => Of(new MissionAck
    {
        TargetSystem = 1,
        TargetComponent = 191,
        Type = result,
        MissionType = MavMissionType.Fence,
    });

    private IEnumerable<MavlinkFrame> Read(ParamRequestRead request)
    {
        string name = request.ParamId.ToString();
        Reads.Add(name);
        return Values.ContainsKey(name) ? [Report(name)] : [];
    }

    private IEnumerable<MavlinkFrame> Set(ParamSet request)
    {
        string name = request.ParamId.ToString();
        if (!Values.TryGetValue(name, out (MavParamType Type, double Value) known))
            return [];
        double value = MavlinkParameter.Decode(BitsOf(request.ParamValue), known.Type, _encoding);
        Sets.Add((name, value));
        if (!ReadOnly.Contains(name))
            Values[name] = (known.Type, value);
        return [Report(name)];
    }

    private MavlinkFrame Report(string name) => Of(new ParamValue
    {
        ParamId = new Text16(name),
        Value = FloatOf(MavlinkParameter.Encode(Values[name].Value, Values[name].Type, _encoding)),
        ParamType = Values[name].Type,
        ParamCount = (ushort)Values.Count,
        ParamIndex = ushort.MaxValue,
    });

    private IEnumerable<MavlinkFrame> Begin(int count)
    {
        _upload.Clear();
        _expected = count;
        return [Request(0)];
    }

    private IEnumerable<MavlinkFrame> Take(MissionItemInt item)
    {
        if (item.Seq == _upload.Count)
            _upload.Add(item);
        if (_upload.Count < _expected)
            return [Request(_upload.Count)];
        Uploads++;
        Fence = [.. _upload];
        return [Acknowledge(MavMissionResult.Accepted)];
    }

    private IEnumerable<MavlinkFrame> Clear()
    {
        Clears++;
        Fence = [];
        return [Acknowledge(MavMissionResult.Accepted)];
    }

    private static MavlinkFrame Request(int seq) => Of(new MissionRequestInt
    {
        TargetSystem = 1,
        TargetComponent = 191,
        Seq = (ushort)seq,
        MissionType = MavMissionType.Fence,
    });

    private static uint BitsOf(float value) => BitConverter.ToUInt32(BitConverter.GetBytes(value), 0);

    private static float FloatOf(uint bits) => BitConverter.ToSingle(BitConverter.GetBytes(bits), 0);
}
