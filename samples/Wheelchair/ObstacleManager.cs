using Rabit.Core;

namespace Wheelchair;

/// <summary>
/// Reads the range sensor and posts what is in front of the chair, with the time at which it was measured.
/// </summary>
internal sealed class ObstacleManager : RabitManager
{
    private readonly BlockingReader<RangeReading> _sensor;
    private readonly MessagePublisher<Obstacle> _obstacle;

    public ObstacleManager(IReaderSource<RangeReading> sensor)
        : base("obstacle")
    {
        _sensor = AttachReader("range", sensor, capacity: 4, QueueFullMode.DropOldest);   // only the newest matters
        _obstacle = Publish<Obstacle>("obstacle");
    }

    protected override void ExecuteUnitOfWork()
    {
        while (_sensor.TryPop(out RangeReading reading))
        {
            _obstacle.Value.DistanceMetres = reading.DistanceMetres;
            _obstacle.PostStamped(reading.At);
        }
    }
}
