using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

// The group that the vehicle searches with: its queues and messages.
public sealed partial class MissionControlManager
{
    private readonly GroupPort? _group;

    /// <summary>The ends of a vehicle in a group. The thread of the manager.</summary>
    private sealed class GroupPort : IGroupSender
    {
        private static readonly TimeSpan ReportPeriod = TimeSpan.FromSeconds(1);

        private readonly MessageSubscriber<OwnAddress> _ownAddress;
        private readonly QueueReceiver<Envelope<GroupReport>> _reports;
        private readonly QueueReceiver<Envelope<LaneDivision>> _divisions;
        private readonly QueueReceiver<Envelope<LaneCoverage>> _coverages;
        private readonly QueueSender<Envelope<GroupReport>> _outgoingReports;
        private readonly QueueSender<Envelope<LaneDivision>> _outgoingDivisions;
        private readonly QueueSender<Envelope<LaneCoverage>> _outgoingCoverages;
        private readonly QueueReceiver<Envelope<ValidationTask>> _tasks;
        private readonly QueueReceiver<Envelope<ValidationBid>> _bids;
        private readonly QueueSender<Envelope<ValidationTask>> _outgoingTasks;
        private readonly QueueSender<Envelope<ValidationBid>> _outgoingBids;
        private readonly QueueReceiver<Envelope<FollowTask>> _follows;
        private readonly QueueReceiver<Envelope<FollowBid>> _followBids;
        private readonly QueueSender<Envelope<FollowTask>> _outgoingFollows;
        private readonly QueueSender<Envelope<FollowBid>> _outgoingFollowBids;
        private readonly MessagePublisher<GroupStatus> _status;
        private readonly MissionGroup _group;
        private TimeSpan _nextReport = TimeSpan.MinValue;
        private int _posted;   // the changes of the division that others know

        public GroupPort(MissionControlManager manager, MissionGroup group)
        {
            _ownAddress = manager.Subscribe<OwnAddress>(MessageNames.OwnAddress);
            _reports = manager.Receive<Envelope<GroupReport>>(
                MessageNames.GroupReports, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
            _divisions = manager.Receive<Envelope<LaneDivision>>(
                MessageNames.LaneDivisions, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
            _coverages = manager.Receive<Envelope<LaneCoverage>>(
                MessageNames.LaneCoverages, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
            _outgoingReports = manager.Send<Envelope<GroupReport>>(MessageNames.OutgoingGroupReports);
            _outgoingDivisions = manager.Send<Envelope<LaneDivision>>(MessageNames.OutgoingLaneDivisions);
            _outgoingCoverages = manager.Send<Envelope<LaneCoverage>>(MessageNames.OutgoingLaneCoverages);
            _tasks = manager.Receive<Envelope<ValidationTask>>(
                MessageNames.ValidationTasks, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
            _bids = manager.Receive<Envelope<ValidationBid>>(
                MessageNames.ValidationBids, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
            _outgoingTasks = manager.Send<Envelope<ValidationTask>>(MessageNames.OutgoingValidationTasks);
            _outgoingBids = manager.Send<Envelope<ValidationBid>>(MessageNames.OutgoingValidationBids);
            _follows = manager.Receive<Envelope<FollowTask>>(
                MessageNames.FollowTasks, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
            _followBids = manager.Receive<Envelope<FollowBid>>(
                MessageNames.FollowBids, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
            _outgoingFollows = manager.Send<Envelope<FollowTask>>(MessageNames.OutgoingFollowTasks);
            _outgoingFollowBids = manager.Send<Envelope<FollowBid>>(MessageNames.OutgoingFollowBids);
            _status = manager.Publish<GroupStatus>(MessageNames.Group);
            (_group, group.Sender) = (group, this);
        }

        public void Receive(MissionFlight flight)
        {
            _ownAddress.Fetch();
            _group.SystemId = _ownAddress.Value.SystemId;
            while (_reports.TryPop(out Envelope<GroupReport> report))
                _group.Receive(flight, report);
            while (_divisions.TryPop(out Envelope<LaneDivision> division))
                _group.Receive(flight, division);
            while (_coverages.TryPop(out Envelope<LaneCoverage> coverage))
                _group.Receive(flight, coverage);
            while (_tasks.TryPop(out Envelope<ValidationTask> task))
                _group.Receive(flight, task);
            while (_bids.TryPop(out Envelope<ValidationBid> bid))
                _group.Receive(flight, bid);
            while (_follows.TryPop(out Envelope<FollowTask> follow))
                _group.Receive(flight, follow);
            while (_followBids.TryPop(out Envelope<FollowBid> followBid))
                _group.Receive(followBid);
        }

        /// <summary>The run: another one begins the numbers of its targets at 1 again.</summary>
        public void Begin(DateTimeOffset utc) => _group.BeginRun((ushort)(utc.Ticks / TimeSpan.TicksPerSecond));

        /// <summary>Another division is posted at once: who shows the group is not to be late by a period.</summary>
        public void Update(MissionFlight flight, MissionPhase phase)
        {
            _group.Update(flight, phase);
            if (_group.DivisionChanges != _posted)
                Post(flight.Now);
        }

        public void Post(TimeSpan now)
        {
            _posted = _group.DivisionChanges;
            _status.Value = _group.Status(now);
            _status.Post();
        }

        // What does not fit into a queue is counted by it, and sent again soon.
        public void Report(in GroupReport report, TimeSpan now)
        {
            if (now < _nextReport)
                return;

            // Once a second on average: ticks are not at whole seconds, and four reports are to fit into SilentAfter.
            bool isLate = _nextReport == TimeSpan.MinValue || now - _nextReport >= ReportPeriod;
            _nextReport = (isLate ? now : _nextReport) + ReportPeriod;
            _ = _outgoingReports.Push(new Envelope<GroupReport> { Content = report });
        }

        public void Send(in LaneDivision division)
            => _ = _outgoingDivisions.Push(new Envelope<LaneDivision> { Content = division });

        public void Send(in LaneCoverage coverage)
            => _ = _outgoingCoverages.Push(new Envelope<LaneCoverage> { Content = coverage });

        public void Send(in ValidationTask task)
            => _ = _outgoingTasks.Push(new Envelope<ValidationTask> { Content = task });

        public void Send(in ValidationBid bid, byte finder) => _ = _outgoingBids.Push(
            new Envelope<ValidationBid> { Content = bid, Destination = VehicleDestination.Vehicle(finder) });

        public void Send(in FollowTask task)
            => _ = _outgoingFollows.Push(new Envelope<FollowTask> { Content = task });

        public void Send(in FollowBid bid, byte decider) => _ = _outgoingFollowBids.Push(
            new Envelope<FollowBid> { Content = bid, Destination = VehicleDestination.Vehicle(decider) });
    }
}
