using System;

// examples of the documentation, in one file: see ExampleTests
#pragma warning disable MA0048, CA1822, CA1859, CA1852, SA1402
#pragma warning disable CA1812, IDE0051, IDE0059, S1144

namespace Rabit.Core.Tests.Documentation;

public sealed class Counter : RabitManager
{
    private readonly MessagePublisher<int> _count;

    public Counter() : base("counter")
    {
        _count = Publish<int>("count");
        Period = TimeSpan.FromMilliseconds(20);
    }

    protected override void ExecuteUnitOfWork()
    {
        _count.Value++;   // fill in the local copy ...
        _count.Post();    // ... and post it
    }
}

public sealed class Gripper : RabitManager
{
    private readonly QueueReceiver<bool> _commands;   // true: close, false: open

    public Gripper() : base("gripper") => _commands = Receive<bool>("gripper commands");

    protected override void ExecuteUnitOfWork()
    {
        while (_commands.TryPop(out bool closes))
            DelaysStop = closes;          // what is held must be put down first
        if (IsStopRequested && DelaysStop)
        {
            PutDown();                    // may take several units of work
            DelaysStop = false;           // the stop continues
        }
    }

    private void PutDown()
    {
    }
}

public sealed class Gps : RabitManager
{
    private readonly BlockingReader<string> _lines;

    // NmeaSource is an IReaderSource<string> that reads a serial line.
    public Gps() : base("gps")
        => _lines = AttachReader("nmea", new NmeaSource("/dev/ttyUSB0"), reconnect: ReconnectPolicy.Always);

    protected override void ExecuteUnitOfWork()
    {
        while (_lines.TryPop(out string? line))
            Log(line);
    }
}

internal struct Pose
{
    public double NorthMetres;
}

internal struct Order
{
    public int Number { get; set; }
}

internal sealed class NmeaSource(string device) : IReaderSource<string>
{
    public bool Blocks => device.Length > 0;

    public void Open(ReaderContext context)
    {
    }

    public ReaderStep Read(out string value)
    {
        value = device;
        return ReaderStep.Ended;
    }

    public void Unblock()
    {
    }

    public void Close()
    {
    }
}

internal sealed class Camera() : RabitManager("camera")
{
    protected override void ExecuteUnitOfWork()
    {
    }
}

internal sealed class Logger() : RabitManager("logger")
{
    protected override void ExecuteUnitOfWork()
    {
    }
}

internal sealed class Display : RabitManager
{
    private readonly MessagePublisher<Pose> _pose;

    public Display()
        : base("display")
    {
        _pose = Publish<Pose>("display pose");
        WakeUpDelay = TimeSpan.FromMilliseconds(100);
    }

    public static void Run()
    {
        var reactor = new RabitReactor { new Counter(), new Display() };
        ReactorResult result = reactor.Run();   // until Ctrl-C, SIGTERM or Stop
        Environment.Exit(result.ExitCode);
    }

    public static ReactorResult RunVirtually()
    {
        var reactor = new RabitReactor(new VirtualTime(seed: 1)) { new Counter(), new Display() };
        reactor.Start();
        reactor.RunFor(TimeSpan.FromHours(1));   // in a second or less
        reactor.Stop();
        ReactorResult result = reactor.Finish();
        return result;
    }

    public static RabitReactor Supervised()
    {
        var camera = new Camera { FaultPolicy = FaultPolicy.Restart };
        var logger = new Logger
        {
            FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromMilliseconds(50), TimeSpan.FromSeconds(5)),
        };
        return [camera, logger];
    }

    protected override void ExecuteUnitOfWork()
    {
        _pose.Value.NorthMetres = 12;   // one member of the local copy
        _pose.Post();

        _pose.Post(new Pose { NorthMetres = 12 });   // or the whole value
    }
}

internal sealed class Pilot : RabitManager
{
    private readonly MessageSubscriber<Pose> _pose;
    private readonly QueueSender<Order> _orders;
    private readonly QueueSender<BufferLease> _pictures;

    public Pilot()
        : base("pilot")
    {
        _pose = Subscribe<Pose>("display pose");
        _orders = Send<Order>("orders");
        _pictures = Send<BufferLease>("pictures");
    }

    protected override void ExecuteUnitOfWork()
    {
        if (_pose.Fetch())                       // is there news?
            Steer(_pose.Value.NorthMetres);

        if (!_pose.IsFresh(TimeSpan.FromSeconds(1)))
            Stop();                              // the last one is too old to act on
        Give(default);
        Photograph();
    }

    private static void Steer(double metres) => _ = metres;

    private static void Fill(Span<byte> bytes) => bytes.Clear();

    private void Stop() => WakeUpDelay = TimeSpan.FromSeconds(2);

    private void Give(Order order)
    {
        if (_orders.Push(order) == PushResult.Rejected)
            Log("the queue of orders is full");
    }

    private void Photograph()
    {
        var pictures = new BufferPool("pictures", count: 8, bufferBytes: 640 * 480 * 3);
        if (pictures.TryRent("camera", out BufferLease picture))
        {
            Fill(picture.Span);
            if (_pictures.Push(picture) == PushResult.Rejected)
                picture.Dispose();   // else the receiver returns it, or a queue that drops it
        }
    }
}

internal sealed class Worker : RabitManager
{
    private readonly QueueReceiver<Order> _orders;

    public Worker()
        : base("worker") => _orders = Receive<Order>("orders");

    protected override void ExecuteUnitOfWork()
    {
        while (_orders.TryPop(out Order order))
            Execute(order);
    }

    private static void Execute(Order order) => _ = order.Number;
}

internal sealed class Relay : RabitManager
{
    private readonly QueueReceiver<Order> _in;
    private readonly QueueSender<Order> _out;

    public Relay()
        : base("relay")
    {
        _in = Receive<Order>("orders in");
        _out = Send<Order>("orders out", wakeOnPop: true);
    }

    protected override void ExecuteUnitOfWork()
    {
        if (!_out.TryPushHeld())
            return;                                // still full: the next pop wakes us
        while (_in.TryPop(out Order order))
        {
            if (!_out.TryPushOrHold(order))
                return;
        }
    }
}
