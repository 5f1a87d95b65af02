using System;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>
/// One of six managers at 50 Hz, each of which posts, fetches its neighbour's post, pushes and pops in every unit of
/// work.
/// </summary>
internal sealed class CrewMember : RabitManager
{
    public const int Crew = 6;

    private readonly MessagePublisher<VehiclePose> _own;
    private readonly MessageSubscriber<VehiclePose> _neighbour;
    private readonly QueueReceiver<int> _inbox;
    private readonly QueueSender<int> _outbox;

    public CrewMember(int number)
        : base("member " + number)
    {
        _own = Publish<VehiclePose>("pose " + number);
        _neighbour = Subscribe<VehiclePose>("pose " + ((number + 1) % Crew));
        _inbox = Receive<int>("inbox " + number, 10, QueueFullMode.DropOldest, wakeOnPush: false);
        _outbox = Send<int>("inbox " + ((number + 2) % Crew));
        Period = TimeSpan.FromMilliseconds(20);
    }

    public int Runs { get; private set; }

    protected override void ExecuteUnitOfWork()
    {
        Runs++;
        if (_neighbour.Fetch())
            _own.Value = _neighbour.Value;
        while (_inbox.TryPop(out _))
        {
        }

        _own.Post();
        _ = _outbox.Push(Runs);
    }
}
