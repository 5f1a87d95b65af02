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
/// continue takes it over. It is planned before the upload is acknowledged, so that what cannot be searched is refused.
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
    private bool _isAbandoned;

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
            DecidesLater = true,
        });
    }

    /// <summary>The messages that it handles.</summary>
    public static IReadOnlyList<int> MessageIds { get; } =
    [
        MissionCount.MavlinkId, MissionItemInt.MavlinkId, MissionRequestList.MavlinkId, MissionRequestInt.MavlinkId,
        MissionRequest.MavlinkId, MissionClearAll.MavlinkId, MissionAck.MavlinkId, MissionSetCurrent.MavlinkId,
        MissionRequestPartialList.MavlinkId, MissionWritePartialList.MavlinkId,
    ];

    /// <summary>How many areas were offered.</summary>
    public int Offers { get; private set; }

    /// <summary>Handles a received frame.</summary>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        // The server answers that without asking.
        if (frame.MessageId == MissionCount.MavlinkId && frame.TryDecode(out MissionCount count)
            && count.Count > MaxItems)
            _announce(FormattableString.Invariant($"area refused: {count.Count} corners; the limit is {MaxItems}"));
        _server.Handle(frame, now);
        while (_server.TryTakeChange(out MavlinkMissionChange change))
        {
            if (change.Count == 0)
                _mission.OfferArea([], [], Authority.NameOf(change.Source), "the fence was cleared");
        }

        // Given up, or begun again.
        if (_offer is not null && !_server.IsDecisionAwaited)
            _isAbandoned = true;
        Offer(now);
    }

    /// <summary>Acknowledges an upload once Mission Control has answered it.</summary>
    public void Update(TimeSpan now)
    {
        if (_offer is not { } offer || offer.Outcome == OperatorOutcome.InProgress)
            return;
        _offer = null;
        bool isAccepted = offer.Outcome == OperatorOutcome.Accepted;
        if (_isAbandoned)
        {
            if (isAccepted)
                _mission.OfferArea([], [], offer.By, "the upload was given up");
            _isAbandoned = false;
            Offer(now);
            return;
        }

        _server.Decide(isAccepted ? MavMissionResult.Accepted : MavMissionResult.Invalid, now);
        _announce($"area {(isAccepted ? "offered" : "refused")}: {offer.Answer}");
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
        if (items.IsEmpty || FencePolygons.TryRead(items, out _, out _) is not { } fault)
            return MavMissionResult.Accepted;
        _announce("area refused: " + fault);
        return MavMissionResult.Invalid;
    }

    private void Offer(TimeSpan now)
    {
        if (_offer is not null || !_server.IsDecisionAwaited)
            return;
        FencePolygons.TryRead(
            _server.AwaitedItems, out ImmutableArray<GeodeticPosition> area,
            out ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts);
        Offers++;
        _offer = _mission.OfferArea(area, keepOuts, Authority.NameOf(_server.Uploader!.Value), "a fence was uploaded");
        Update(now);
    }
}
