using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.GroundControl;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.GroundControl;

/// <summary>MAVLink commands for our component, with Mission Control in a flight.</summary>
public sealed class GroundCommandTests : IDisposable
{
    private const byte Station = 255;
    private const byte Us = 191;

    private readonly MissionRig _flight = MissionRig.In(MissionPhase.Searching);
    private readonly RabitReactor _reactor;
    private readonly MessagePublisher<OwnAddress> _address;
    private readonly QueueSender<LinkFrame> _in;
    private readonly QueueReceiver<OutgoingFrame> _out;
    private readonly List<string> _log = [];
    private readonly List<string> _texts = [];
    private byte _sequence;

    public GroundCommandTests()
    {
        var manager = new GroundCommandManager(_flight.Manager, new GroundCommandOptions());
        _reactor = new RabitReactor(new ReactorOptions
        {
            Time = new VirtualTime(1),
            StopsOnSignals = false,
            Log = e => _log.Add(e.ToString()),
        })
        {
            manager,
        };
        _address = _reactor.Workspace.Publish<OwnAddress>(MessageNames.OwnAddress);
        _in = _reactor.Workspace.Send<LinkFrame>(GroundCommandManager.CreateSubscription().Queue);
        _out = _reactor.Workspace.Receive<OutgoingFrame>(MessageNames.OutgoingFrames);
        _reactor.Start();
        _address.Value = new OwnAddress { SystemId = 1, ComponentId = Us };
        _address.Post();
        Run(0.5);
    }

    [Theory]
    [InlineData(MavCmd.DoPauseContinue, 0, 0, MissionPhase.Holding)]
    [InlineData(MavCmd.NavReturnToLaunch, 0, 0, MissionPhase.Returning)]
    [InlineData(MavCmd.NavLand, 0, 0, MissionPhase.Landing)]
    [InlineData(MavCmd.User1, 1, 0, MissionPhase.InTransit)]
    [InlineData(MavCmd.DoChangeSpeed, 1, 5, MissionPhase.Searching)]
    public void Command_ForUs_IsExecutedAndAcknowledged(MavCmd command, float p1, float p2, MissionPhase expected)
    {
        Send(command, p1, p2);
        Run(0.4);
        CommandAck ack = Assert.Single(Answers());
        Assert.Equal(
            (command, MavResult.Accepted, Station), (ack.Command, ack.Result, ack.TargetSystem));
        Assert.Equal(expected, _flight.Status.Phase);
        Assert.Contains($"operator system 255 component 190: ", _flight.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Command_PauseThenContinueOrStart_GoesOn()
    {
        Send(MavCmd.DoPauseContinue, 0);
        Run(1);
        Send(MavCmd.DoPauseContinue, 1);
        Run(1);
        Assert.NotEqual(MissionPhase.Holding, _flight.Status.Phase);
        Send(MavCmd.DoPauseContinue, 0);
        Run(1);
        Send(MavCmd.MissionStart);
        Run(1);
        Assert.NotEqual(MissionPhase.Holding, _flight.Status.Phase);
        Assert.All(Answers(), a => Assert.Equal(MavResult.Accepted, a.Result));
    }

    [Fact]
    public void Command_ForOurComponentOfAllSystems_IsExecutedOnceAndAcknowledged()
    {
        Send(MavCmd.DoPauseContinue, 0, system: 0);
        Run(0.5);
        Send(MavCmd.DoPauseContinue, 0, system: 0);
        Run(0.5);
        Assert.All(Answers(), a => Assert.Equal((MavResult.Accepted, Station), (a.Result, a.TargetSystem)));
        Assert.Equal(MissionPhase.Holding, _flight.Status.Phase);
        Assert.Single(Regex.Matches(_flight.Story, "operator system 255 component 190: hold").Cast<Match>());
    }

    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void Command_AboutATrackOfAllSystems_IsDenied(float action)
    {
        Send(MavCmd.User1, action, 1, system: 0);
        Run(0.5);
        Assert.Equal(MavResult.Denied, Assert.Single(Answers()).Result);
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(0, 1)]
    [InlineData(2, Us)]
    public void Command_ForAllComponentsOrAnotherSystem_IsNeitherExecutedNorAcknowledged(byte system, byte component)
    {
        Send(MavCmd.NavReturnToLaunch, component: component, system: system);
        Run(2);
        Assert.Empty(Answers());
        Assert.Equal(MissionPhase.Searching, _flight.Status.Phase);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void Command_ForAllOrForTheAutopilot_IsNeitherExecutedNorAcknowledged(byte component)
    {
        Send(MavCmd.NavReturnToLaunch, component: component);
        Run(3);
        Assert.Empty(Answers());
        Assert.Equal(MissionPhase.Searching, _flight.Status.Phase);
    }

    [Theory]
    [InlineData(MavCmd.DoSetMode, 0, 0, MavResult.Unsupported)]
    [InlineData(MavCmd.DoPauseContinue, 7, 0, MavResult.Denied)]
    [InlineData(MavCmd.User1, 9, 1, MavResult.Denied)]
    [InlineData(MavCmd.User1, 2, 0.5f, MavResult.Denied)]
    [InlineData(MavCmd.User1, 2, 99, MavResult.Failed)]
    [InlineData(MavCmd.DoChangeSpeed, 1, 50, MavResult.Failed)]
    [InlineData(MavCmd.DoChangeSpeed, 1, float.NaN, MavResult.Failed)]
    [InlineData(MavCmd.MissionStart, 0, 0, MavResult.Failed)]
    public void Command_ThatCannotBe_IsAnsweredAndChangesNothing(MavCmd command, float p1, float p2, MavResult expected)
    {
        Send(command, p1, p2);
        Run(1);
        Assert.Equal(expected, Assert.Single(Answers()).Result);
        Assert.Equal(MissionPhase.Searching, _flight.Status.Phase);

        // The acknowledgement has no room for the reason.
        Assert.Equal(expected == MavResult.Failed, _texts.Count > 0);
    }

    [Fact]
    public void Command_OfAnotherSystem_IsDeniedAndLogged()
    {
        Send(MavCmd.NavReturnToLaunch, from: 42);
        Run(1);
        Assert.Equal(MavResult.Denied, Assert.Single(Answers()).Result);
        Assert.Equal(MissionPhase.Searching, _flight.Status.Phase);
        Assert.Contains(_log, l => l.Contains(
            "NAV_RETURN_TO_LAUNCH of system 42 component 190 denied: it may not command", StringComparison.Ordinal));
    }

    // No link: the answer takes longer than half a second.
    [Fact]
    public void Command_ThatWaits_IsInProgressAndThenFails()
    {
        _flight.Vehicle.IsConnected = false;
        Run(5);
        Send(MavCmd.DoPauseContinue, 0);
        Run(14);
        MavResult[] results = [.. Answers().Select(a => a.Result)];
        Assert.Contains(MavResult.InProgress, results);
        Assert.Equal(MavResult.Failed, results[results.Length - 1]);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Command_RegionOfInterest_RevisitsThePlace(bool isInt)
    {
        const double Latitude = 47.39860;
        const double Longitude = 8.54560;
        if (isInt)
        {
            Push(MavlinkFrame.Create(
                new CommandInt
                {
                    Command = MavCmd.DoSetRoiLocation,
                    TargetSystem = 1,
                    TargetComponent = Us,
                    X = (int)(Latitude * 1e7),
                    Y = (int)(Longitude * 1e7),
                },
                Station, 190, _sequence++));
        }
        else
        {
            Push(MavlinkFrame.Create(
                new CommandLong
                {
                    Command = MavCmd.DoSetRoiLocation,
                    TargetSystem = 1,
                    TargetComponent = Us,
                    Param5 = (float)Latitude,
                    Param6 = (float)Longitude,
                },
                Station, 190, _sequence++));
        }

        Run(1);
        Assert.Equal(MavResult.Accepted, Assert.Single(Answers()).Result);
        Assert.Equal((MissionPhase.Revisiting, "revisiting a place"), (_flight.Status.Phase, _flight.Status.Text));
    }

    public void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
        _flight.Dispose();
    }

    private void Send(
        MavCmd command, float p1 = 0, float p2 = 0, byte component = Us, byte from = Station, byte system = 1)
        => Push(MavlinkFrame.Create(
            new CommandLong
            {
                Command = command,
                TargetSystem = system,
                TargetComponent = component,
                Param1 = p1,
                Param2 = p2,
            },
            from, 190, _sequence++));

    private void Push(MavlinkFrame frame) => _in.Push(new LinkFrame { Frame = frame, IsChecked = true });

    private void Run(double seconds)
    {
        for (double t = 0; t < seconds; t += 0.1)
        {
            _reactor.RunFor(TimeSpan.FromSeconds(0.1));
            _flight.Run(0.1);
        }
    }

    private List<CommandAck> Answers()
    {
        Run(0.3);
        var answers = new List<CommandAck>();
        while (_out.TryPop(out OutgoingFrame frame))
        {
            Assert.Equal((1, Us), (frame.Frame.SystemId, frame.Frame.ComponentId));
            if (frame.Frame.TryDecode(out Statustext text))
            {
                _texts.Add(text.Text.ToString());
                continue;
            }

            // The speed is a parameter too.
            if (frame.Frame.MessageId == ParamValue.MavlinkId)
                continue;
            Assert.True(frame.Frame.TryDecode(out CommandAck ack));
            answers.Add(ack);
        }

        return answers;
    }
}
