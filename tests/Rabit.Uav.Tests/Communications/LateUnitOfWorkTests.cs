using System;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Time that goes on while a unit of work lasts: on a busy computer by more than what is due next.</summary>
public sealed class LateUnitOfWorkTests
{
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(60);

    // Seen on a computer with a load of 15: Communications faulted, and the vehicle returned.
    [Fact]
    public async Task UnitOfWork_LongerThanUntilTheNextDatagram_IsNoFault()
    {
        var clock = new ShiftedClock();
        var codec = new SlowCodec(clock);
        var pair = new MemoryLinkPair("air", 64 * 1024);
        var communications = new CommunicationsManager(new CommunicationsOptions
        {
            Links = [pair.A],
            VehicleMessageRoutes =
            [
                new VehicleMessageRoute<TargetReport>(
                    codec, MessageNames.OutgoingTargetReports, MessageNames.TargetReports),
            ],
            VehicleExchange = { Groups = [1] },   // so that it announces itself: something is always due
        });
        var reactor = new RabitReactor(new RealTime(clock))
        {
            communications, new ReportSink(), new FakeAutopilot(1024), new Surroundings(),
        };
        Task<ReactorResult> run = reactor.RunAsync();
        byte[] first = VehicleMessageTests.FrameOf(VehicleMessageTests.Report(picture: 1), system: 5);
        pair.B.Write(first, 0, first.Length);
        Assert.Same(codec.HasDecoded.Task, await Task.WhenAny(codec.HasDecoded.Task, run, Task.Delay(MaxWait)));
        reactor.Stop("test");

        ManagerResult result = (await run).Managers.Single(m => m.Name == CommunicationsManager.ManagerName);
        Assert.Empty(result.Faults);
    }

    private sealed class Surroundings : RabitManager
    {
        private readonly MessagePublisher<OwnAddress> _address;

        public Surroundings()
            : base("surroundings")
        {
            _address = Publish(
                MessageNames.OwnAddress, new OwnAddress { SystemId = 1, ComponentId = 191 });
            Publish<VehicleState>(MessageNames.VehicleState);
            Send<Envelope<TargetReport>>(MessageNames.OutgoingTargetReports);
        }

        protected override void Startup() => _address.Post();

        protected override void ExecuteUnitOfWork()
        {
        }
    }

    private sealed class SlowCodec(ShiftedClock clock) : IVehicleMessageCodec<TargetReport>
    {
        private readonly TargetReportCodec _codec = new();

        public TaskCompletionSource<bool> HasDecoded { get; } = new();

        public int MessageType => _codec.MessageType;

        public int Version => _codec.Version;

        public bool TryEncode(in TargetReport content, TimeSpan now, Span<byte> destination, out int length)
            => _codec.TryEncode(content, now, destination, out length);

        public bool TryDecode(
            ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out TargetReport content)
        {
            clock.GoOn(TimeSpan.FromSeconds(30));
            HasDecoded.TrySetResult(true);
            return _codec.TryDecode(bytes, version, sentTime, sourceSystemId, out content);
        }
    }

    private sealed class ShiftedClock : TimeProvider
    {
        private long _shift;

        public override long GetTimestamp() => System.GetTimestamp() + Volatile.Read(ref _shift);

        public void GoOn(TimeSpan time)
            => Interlocked.Add(ref _shift, (long)(time.TotalSeconds * System.TimestampFrequency));
    }
}
