using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.GroundControl;

/// <summary>
/// The values of the mission as parameters of our component. A PARAM_SET waits until Mission Control has answered it;
/// only then is it answered itself.
/// </summary>
internal sealed class GroundParameters : IMavlinkParameterStore
{
    // A station sets one after the other.
    private const int MaxWaiting = 16;

    private readonly IMissionOperator _mission;
    private readonly Authority _authority;
    private readonly MavlinkAddress _own;
    private readonly MavlinkParameterServer _server;
    private readonly List<(MavlinkFrame Frame, OperatorRequest Request)> _waiting = [];
    private readonly double[] _shown = new double[MissionParameterTable.All.Count];
    private OperatorRequest? _answered;
    private bool _isTooMany;

    public GroundParameters(IMissionOperator mission, Authority authority, MavlinkSender sender)
    {
        (_mission, _authority) = (mission, authority);
        _own = new MavlinkAddress(sender.SystemId, sender.ComponentId);
        _server = new MavlinkParameterServer(sender, this, MavlinkParameterEncoding.Bytewise);
        for (int i = 0; i < _shown.Length; i++)
            _shown[i] = ValueOf(i);
    }

    /// <summary>The messages that it handles.</summary>
    public static IReadOnlyList<int> MessageIds { get; } =
        [ParamRequestList.MavlinkId, ParamRequestRead.MavlinkId, ParamSet.MavlinkId];

    /// <summary>Without a mission there are none.</summary>
    public int Count => _mission.Mission is null ? 0 : MissionParameterTable.All.Count;

    public MavlinkParameterValue this[int index]
        => new(new Text16(MissionParameterTable.All[index].Name), MavParamType.Real32, ValueOf(index));

    /// <summary>Handles a received frame.</summary>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (FindChange(frame) is not { } request)
        {
            _server.Handle(frame, now);
        }
        else if (_waiting.Count < MaxWaiting)
        {
            _mission.Give(request);
            _waiting.Add((frame, request));
        }
        else
        {
            _isTooMany = true;
            _server.Handle(frame, now);
            _isTooMany = false;
        }
    }

    /// <summary>Answers what Mission Control has answered, and says what has changed from elsewhere.</summary>
    public void Update(TimeSpan now)
    {
        for (int i = 0; i < _waiting.Count; i++)
        {
            (MavlinkFrame frame, OperatorRequest request) = _waiting[i];
            if (request.Outcome == OperatorOutcome.InProgress)
                continue;
            _waiting.RemoveAt(i--);
            _answered = request;
            _shown[IndexOf(request.Parameter)] = _mission.Mission!.Get(request.Parameter);
            _server.Handle(frame, now);
            _answered = null;
        }

        for (int i = 0; i < Count; i++)
        {
            if (_shown[i].Equals(ValueOf(i)))
                continue;
            _shown[i] = ValueOf(i);
            _server.Report(i);
        }
    }

    /// <summary>Takes the next frame to send.</summary>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame) => _server.TryTakeFrame(now, out frame);

    /// <summary>What the server asks where nothing has to be waited for, or the answer is there.</summary>
    public bool TrySet(in MavlinkParameterChange change, out MavlinkParameterRefusal refusal)
    {
        refusal = default;
        string? reason = _authority.FindDenial(change.Source, change.IsSigned)
            ?? (_isTooMany ? "too many changes are at work" : null);
        if (reason is null && _answered is { Outcome: OperatorOutcome.Accepted })
            return true;
        bool isWrong = reason is null && _mission.Mission is { } mission && MissionPlanRules.FindFaults(
            mission.With(MissionParameterTable.All[change.Index].Parameter, change.Value)).Any();
        refusal = new MavlinkParameterRefusal(
            isWrong ? MavParamError.ValueOutOfRange : MavParamError.PermissionDenied,
            $"{change.Parameter.Name}: {reason ?? _answered?.Answer}");
        return false;
    }

    private static int IndexOf(MissionParameter parameter)
    {
        int index = 0;
        while (MissionParameterTable.All[index].Parameter != parameter)
            index++;
        return index;
    }

    // Those of another name or type, or from a sender that may not, are refused without Mission Control.
    private OperatorRequest? FindChange(in MavlinkFrame frame)
    {
        if (frame.MessageId != ParamSet.MavlinkId || !frame.TryDecode(out ParamSet set)
            || new MavlinkAddress(set.TargetSystem, set.TargetComponent) != _own
            || set.ParamType != MavParamType.Real32 || float.IsNaN(set.ParamValue) || float.IsInfinity(set.ParamValue))
            return null;
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        int index = Count == 0 ? -1 : MissionParameterTable.IndexOf(set.ParamId.ToString());
        if (index < 0 || _authority.FindDenial(source, frame.IsSigned) is not null)
            return null;
        return new OperatorRequest(
            OperatorCommand.ChangeParameter, Authority.NameOf(source), MissionParameterTable.All[index].Name)
        {
            Parameter = MissionParameterTable.All[index].Parameter,
            Value = ToDecimal(set.ParamValue),
        };
    }

    // 6.1 as a float is not 6.1: what was meant is the shortest number that gives the same float.
    private static double ToDecimal(float value)
        => double.Parse(value.ToString("R", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);

    private double ValueOf(int index) => _mission.Mission?.Get(MissionParameterTable.All[index].Parameter) ?? 0;
}
