using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.GroundControl;

/// <summary>
/// A fence that is uploaded to our component is an area with its keep-outs that is offered: the operator's next
/// continue takes it over. What cannot be searched is refused with the last item of the upload.
/// </summary>
internal sealed class GroundAreas : IMavlinkMissionRules
{
    // As many corners as a mission may have: those of the area and those of all keep-outs.
    private const int MaxItems = 100;

    private readonly IMissionOperator _mission;
    private readonly Authority _authority;
    private readonly Action<string> _announce;
    private readonly MavlinkMissionServer _server;
    private OperatorRequest? _offer;

    /// <param name="mission">Takes the area.</param>
    /// <param name="authority">Who may upload it.</param>
    /// <param name="sender">Gives the frames their source.</param>
    /// <param name="announce">Takes a text for the ground stations.</param>
    public GroundAreas(IMissionOperator mission, Authority authority, MavlinkSender sender, Action<string> announce)
    {
        (_mission, _authority, _announce) = (mission, authority, announce);
        _server = new MavlinkMissionServer(sender, this, new MavlinkMissionServerOptions
        {
            HasMission = false,
            HasRally = false,
            MaxItems = MaxItems,
        });
    }

    /// <summary>The messages that it handles.</summary>
    public static IReadOnlyList<int> MessageIds { get; } =
    [
        MissionCount.MavlinkId, MissionItemInt.MavlinkId, MissionRequestList.MavlinkId, MissionRequestInt.MavlinkId,
        MissionRequest.MavlinkId, MissionClearAll.MavlinkId, MissionAck.MavlinkId, MissionSetCurrent.MavlinkId,
        MissionRequestPartialList.MavlinkId, MissionWritePartialList.MavlinkId,
    ];

    /// <summary>Handles a received frame.</summary>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        // The server answers that without asking.
        if (frame.MessageId == MissionCount.MavlinkId && frame.TryDecode(out MissionCount count)
            && count.Count > MaxItems)
            _announce(FormattableString.Invariant($"area refused: {count.Count} corners; the limit is {MaxItems}"));
        _server.Handle(frame, now);
        while (_server.TryTakeChange(out MavlinkMissionChange change))
            Offer(Authority.NameOf(change.Source));
    }

    /// <summary>Says what became of an area that was offered.</summary>
    public void Update()
    {
        if (_offer is not { } offer || offer.Outcome == OperatorOutcome.InProgress)
            return;
        _offer = null;
        if (offer.Outcome == OperatorOutcome.Accepted)
            _announce(offer.Area.IsEmpty ? "area withdrawn" : "area offered: " + offer.Answer);
        else
            Refuse(offer.Answer);
    }

    /// <summary>Takes the next frame to send.</summary>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame) => _server.TryTakeFrame(now, out frame);

    /// <inheritdoc/>
    public MavMissionResult CheckTransfer(MavMissionType type, int count, MavlinkAddress source, bool isSigned)
    {
        string? denial = _mission.Mission is null ? "there is no mission" : _authority.FindDenial(source, isSigned);
        if (denial is null)
            return MavMissionResult.Accepted;
        _announce($"area of {Authority.NameOf(source)} denied: {denial}");
        return MavMissionResult.Denied;
    }

    /// <inheritdoc/>
    public MavMissionResult CheckItem(in MissionItemInt item)
    {
        MavMissionResult result = FencePolygons.Check(item);
        if (result != MavMissionResult.Accepted)
            _announce(FormattableString.Invariant($"area refused: item {item.Seq}: {result}"));
        return result;
    }

    /// <inheritdoc/>
    public MavMissionResult CheckItems(MavMissionType type, ReadOnlySpan<MissionItemInt> items)
    {
        if (items.IsEmpty)
            return MavMissionResult.Accepted;
        string? fault = FencePolygons.TryRead(
            items, out ImmutableArray<GeodeticPosition> area,
            out ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts) ?? _mission.FindFaultOfArea(area, keepOuts);
        if (fault is null)
            return MavMissionResult.Accepted;
        _announce("area refused: " + fault);
        return MavMissionResult.Invalid;
    }

    private void Offer(string by)
    {
        FencePolygons.TryRead(
            _server.Items(MavMissionType.Fence), out ImmutableArray<GeodeticPosition> area,
            out ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts);
        _offer = _mission.OfferArea(area, keepOuts, by, area.IsEmpty ? "the fence was cleared" : "a fence was uploaded");
    }

    // It was planned when its last item arrived; since then something else has changed.
    private void Refuse(string why)
    {
        _server.Store(MavMissionType.Fence, []);
        _announce("area refused: " + why);
    }
}
