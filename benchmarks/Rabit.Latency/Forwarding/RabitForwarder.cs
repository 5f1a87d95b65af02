using System;
using System.IO;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Latency.Forwarding;

/// <summary>
/// Communications between two UDP links, with or without a recording; Autopilot Interface is stood in for.
/// </summary>
internal sealed class RabitForwarder : IForwarder
{
    private readonly UdpListenLink _in = UdpListenLink.Open("127.0.0.1", 0);
    private readonly UdpSendLink _out;
    private readonly RabitReactor _reactor;
    private readonly string? _folder;

    public RabitForwarder(int target, bool isRecorded)
    {
        _out = UdpSendLink.Open("127.0.0.1", target);
        var options = new CommunicationsOptions { Links = [_in, _out], PositionRateHz = 0 };
        if (isRecorded)
        {
            _folder = Path.Combine(Path.GetTempPath(), "rabit-forwarding-" + Guid.NewGuid().ToString("N"));
            options.Recording = new RecordingOptions { Folder = _folder };
        }

        _reactor = RabitRun.Create(WaitEngine.Futex);
        _reactor.Add(new CommunicationsManager(options));
        _reactor.Add(new Others());
        _reactor.Start();
    }

    public int Port => _in.Port;

    public void Dispose()
    {
        RabitRun.End(_reactor);
        _in.Dispose();
        _out.Dispose();
        if (_folder is not null && Directory.Exists(_folder))
            Directory.Delete(_folder, recursive: true);
    }

    /// <summary>Takes what Communications hands over, four times a second.</summary>
    private sealed class Others : RabitManager
    {
        private readonly QueueReceiver<LinkFrame> _frames;

        public Others()
            : base("others")
        {
            Publish(MessageNames.OwnAddress, new OwnAddress { SystemId = 1, ComponentId = 191 });
            Publish<VehicleState>(MessageNames.VehicleState);
            Send<OutgoingFrame>(MessageNames.OutgoingFrames);
            _frames = Receive<LinkFrame>(
                MessageNames.AutopilotFrames, 1024, QueueFullMode.DropOldest, wakeOnPush: false);
            WakeUpDelay = TimeSpan.FromMilliseconds(250);
        }

        protected override void ExecuteUnitOfWork()
        {
            while (_frames.TryPop(out _))
            {
            }
        }
    }
}
