using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.AutopilotInterface;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>
/// What the rules find in a recorded flight: the log is played to Autopilot Interface and Health Monitoring in virtual
/// time, as in a search, so that their advice shows.
/// </summary>
internal static class RecordedHealth
{
    // What is no matter of position or battery: nothing is asked of a recorded autopilot, and a log has pauses.
    private const HealthReasons OfTheReplay = HealthReasons.NoAutopilot | HealthReasons.AutopilotLost
        | HealthReasons.CommandsUnanswered | HealthReasons.LinkSilent | HealthReasons.WindHigh
        | HealthReasons.AutopilotCritical;

    private static readonly TimeSpan Step = TimeSpan.FromSeconds(0.25);

    /// <summary>Where the whole recordings are; null where they are not.</summary>
    public static string? Folder(string name)
    {
        string? root = Environment.GetEnvironmentVariable("RABIT_VECTORS") is { Length: > 0 } named
            ? named
            : Path.Combine(Rabit.Tests.Shared.Repository.Root, "..", "shared", "vectors");
        string folder = Path.Combine(root, name);
        return Directory.Exists(folder) ? folder : null;
    }

    /// <summary>When each reason was found and ended, with its advice: "12.3-15.0 PositionFixPoor".</summary>
    public static List<string> Play(string path)
    {
        using var reactor = new Played();
        return reactor.Play(path);
    }

    private sealed class Played : IDisposable
    {
        private readonly RabitReactor _reactor;
        private readonly QueueSender<LinkFrame> _frames;
        private readonly MessageSubscriber<HealthReport> _health;
        private readonly MessageSubscriber<VehicleState> _vehicle;
        private readonly Dictionary<HealthReasons, TimeSpan> _since = [];
        private readonly List<(TimeSpan From, string Text)> _found = [];

        public Played()
        {
            var sink = new OutgoingSink();
            _reactor = new RabitReactor(new VirtualTime(1))
            {
                new AutopilotManager(new AutopilotOptions { RequestsRates = false }), sink, new AutopilotPeers(),
                new HealthManager(new HealthOptions(), [], linkCount: 0),
            };
            RabitWorkspace workspace = _reactor.Workspace;
            _frames = workspace.Send<LinkFrame>(MessageNames.AutopilotFrames);
            MessagePublisher<MissionStatus> mission = workspace.Publish<MissionStatus>(MessageNames.Mission);
            workspace.Publish<ImagingStatus>(MessageNames.Imaging);
            _health = workspace.Subscribe<HealthReport>(MessageNames.Health);
            _vehicle = workspace.Subscribe<VehicleState>(MessageNames.VehicleState);
            workspace.Send<VehicleCommand>(MessageNames.VehicleCommands);
            _reactor.Start();
            mission.Value.Phase = MissionPhase.Searching;
            mission.Post();
        }

        public List<string> Play(string path)
        {
            using FileStream file = File.OpenRead(path);
            var log = new TlogReader(file, MavlinkDialect.All);
            long? first = null;
            while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
            {
                first ??= record.TimeMicroseconds;
                RunTo(TimeSpan.FromTicks((record.TimeMicroseconds - first.Value) * 10));
                if (frame.ComponentId != 191)
                {
                    _frames.Push(new LinkFrame
                    {
                        Frame = frame,
                        Index = record.Index,
                        Time = _reactor.Now,
                        UtcMicroseconds = record.TimeMicroseconds,
                    });
                }
            }

            RunTo(_reactor.Now + Step);
            foreach (HealthReasons reason in _since.Keys.ToArray())
                End(reason);
            return _found.OrderBy(f => f.From).Select(f => f.Text).ToList();
        }

        public void Dispose()
        {
            _reactor.Stop();
            _reactor.Finish();
        }

        private void RunTo(TimeSpan time)
        {
            while (_reactor.Now < time)
            {
                TimeSpan left = time - _reactor.Now;
                _reactor.RunFor(left < Step ? left : Step);
                Observe();
            }
        }

        private void Observe()
        {
            _health.Fetch();
            _vehicle.Fetch();
            HealthReasons now = _health.Value.Reasons & ~OfTheReplay;
            foreach (HealthReasons reason in EnumValues.Of<HealthReasons>())
            {
                bool isFound = reason != HealthReasons.None && (now & reason) != 0;
                if (isFound && !_since.ContainsKey(reason))
                    _since.Add(reason, _reactor.Now);
                else if (!isFound && _since.ContainsKey(reason))
                    End(reason);
            }
        }

        private void End(HealthReasons reason)
        {
            TimeSpan since = _since[reason];
            _since.Remove(reason);
            string text = string.Format(
                CultureInfo.InvariantCulture, "{0:0}-{1:0} {2}", since.TotalSeconds, _reactor.Now.TotalSeconds, reason);
            _found.Add((since, text));
        }
    }
}
