using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>A simulated ground station over a radio, with vehicles that only acknowledge.</summary>
public sealed class SimulatedGroundStationTests
{
    private const int Seed = 4;

    [Fact]
    public void Command_ToOne_IsObeyedByItAlone()
    {
        var rig = new Rig(new SimulatedRadioOptions());
        StationCommand command = rig.Stations[0].Command(2, OperatorCommand.Return);
        rig.Run(2);
        Assert.Equal(("return of vehicle 2", "accepted by 2"), (command.Name, command.Answer));
        Assert.True(command.IsDone);
        Assert.Equal([0, 1, 0], rig.Vehicles.Select(v => v.Obeyed.Count));
        Assert.Equal(MavCmd.NavReturnToLaunch, rig.Vehicles[1].Obeyed[0].Command);
    }

    [Fact]
    public void Command_ToAll_IsObeyedByEachOnce()
    {
        var rig = new Rig(new SimulatedRadioOptions());
        StationCommand command = rig.Stations[0].Command(0, OperatorCommand.Hold);
        rig.Run(2);
        Assert.Equal(("hold of all", "accepted by 1, 2, 3"), (command.Name, command.Answer));
        Assert.All(rig.Vehicles, v => Assert.Single(v.Obeyed));
    }

    [Fact]
    public void Command_ToAVehicleThatDoesNotExist_SaysSoAtOnceAndSendsNothing()
    {
        var rig = new Rig(new SimulatedRadioOptions());
        long before = rig.Radio.CountersOf(3).FramesSent;
        StationCommand command = rig.Stations[0].Command(9, OperatorCommand.Land);
        rig.Run(0.02);
        Assert.True(command.IsDone);
        Assert.Equal("there is no vehicle 9; received were 1, 2, 3", command.Answer);
        Assert.InRange(rig.Radio.CountersOf(3).FramesSent - before, 0, 1);
    }

    [Fact]
    public void Command_BeforeAnyVehicleWasReceived_SaysSo()
    {
        var rig = new Rig(new SimulatedRadioOptions { Loss = 1 });
        StationCommand command = rig.Stations[0].Command(0, OperatorCommand.Hold);
        rig.Run(1);
        Assert.Equal("no vehicle was received yet", command.Answer);
    }

    [Fact]
    public void Command_IsLostAndDoubled_IsSentAgainAndObeyedOnce()
    {
        var rig = new Rig(new SimulatedRadioOptions { Loss = 0.5, DuplicateFraction = 0.5 });
        rig.Run(10);
        StationCommand command = rig.Stations[0].Command(0, OperatorCommand.Return);
        rig.Run(12);
        Assert.True(command.Answer == "accepted by 1, 2, 3", $"seed {Seed}: {command.Answer}");
        Assert.All(rig.Vehicles, v => Assert.Single(v.Obeyed));
        Assert.True(rig.Vehicles.Sum(v => v.Server.Repeats) > 0, $"seed {Seed}");
    }

    [Fact]
    public void Command_InAPartition_NamesWhoDidNotAnswerAndReachesItAfterwards()
    {
        var rig = new Rig(new SimulatedRadioOptions
        {
            Partitions = [new RadioPartition(TimeSpan.FromSeconds(4), TimeSpan.FromSeconds(20), [1])],
        });
        rig.Run(2);
        StationCommand command = rig.Stations[0].Command(0, OperatorCommand.Hold);
        rig.Run(3);
        Assert.Equal("accepted by 1, 3; no answer yet of 2", command.Answer);
        rig.Run(10);
        Assert.True(command.IsDone);
        Assert.Equal("accepted by 1, 3; no answer of 2", command.Answer);
        Assert.All(rig.Vehicles, v => Assert.Equal(v.Id == 2 ? 0 : 1, v.Obeyed.Count));

        rig.Run(8);
        StationCommand again = rig.Stations[0].Command(2, OperatorCommand.Hold);
        rig.Run(2);
        Assert.Equal("accepted by 2", again.Answer);
    }

    [Fact]
    public void Commands_OfOneKindToOneVehicle_WaitForEachOther()
    {
        var rig = new Rig(new SimulatedRadioOptions());
        StationCommand[] given =
        [
            rig.Stations[0].Command(0, OperatorCommand.Hold), rig.Stations[0].Command(1, OperatorCommand.Continue),
            rig.Stations[0].Command(1, OperatorCommand.Hold),
        ];
        rig.Run(3);
        Assert.All(given, g => Assert.StartsWith("accepted by 1", g.Answer, StringComparison.Ordinal));
        Assert.Equal([0f, 1f, 0f], rig.Vehicles[0].Obeyed.Select(c => c.Param1));
        Assert.Single(rig.Vehicles[1].Obeyed);
    }

    [Fact]
    public void Command_Refused_SaysByWhom()
    {
        var rig = new Rig(new SimulatedRadioOptions());
        rig.Vehicles[1].Result = MavResult.Failed;
        StationCommand command = rig.Stations[0].Command(0, OperatorCommand.SkipLane);
        rig.Run(2);
        Assert.Equal("accepted by 1, 3; refused by 2", command.Answer);
        Assert.Equal(MavResult.Failed, command.Answers[1].Result);
    }

    [Fact]
    public void Commands_OfTwoStations_AreAnsweredToTheStationThatGaveThem()
    {
        var rig = new Rig(new SimulatedRadioOptions());
        StationCommand first = rig.Stations[0].Command(1, OperatorCommand.Hold);
        StationCommand second = rig.Stations[1].Command(0, OperatorCommand.Return);
        var done = new List<StationCommand>();
        rig.Stations[0].OnDone = (_, c) => done.Add(c);
        rig.Run(2);
        Assert.Equal(("accepted by 1", "accepted by 1, 2, 3"), (first.Answer, second.Answer));
        Assert.Equal([first], done);
        Assert.Equal([255, 254], rig.Stations.Select(s => (int)s.SystemId));
    }

    [Theory]
    [InlineData(0, OperatorCommand.Revisit, 3)]
    [InlineData(1, OperatorCommand.Revisit, 0)]
    [InlineData(1, OperatorCommand.Hold, 3)]
    [InlineData(1, OperatorCommand.OfferArea, 0)]
    public void Command_ThatMakesNoSense_IsNotTaken(byte vehicle, OperatorCommand command, int track)
    {
        var rig = new Rig(new SimulatedRadioOptions());
        Assert.Throws<ArgumentException>(() => rig.Stations[0].Command(vehicle, command, track));
    }

    [Fact]
    public void Options_StationsOutOfRange_AreNamed()
    {
        var options = new SimulatedGroupOptions
        {
            GroundStations = [.. Enumerable.Repeat(new SimulatedStationPlace(double.NaN, 0), 5)],
        };
        ArgumentException e = Assert.Throws<ArgumentException>(() => new SimulatedGroup(options));
        Assert.Contains("GroundStations has 5; it must have 0 to 4", e.Message);
        Assert.Contains("GroundStations has one at ", e.Message);
    }

    // Three vehicles and two stations.
    private sealed class Rig
    {
        private TimeSpan _now;

        public Rig(SimulatedRadioOptions options)
        {
            Radio = new SimulatedRadio(options, Seed);
            NedPosition Place() => NedPosition.Origin;
            Vehicles = [.. Enumerable.Range(1, 3).Select(i => new Vehicle((byte)i, Radio.Add(Place)))];
            Stations = [.. Enumerable.Range(0, 2).Select(i => new SimulatedGroundStation(
                (byte)(255 - i), Radio.Add(Place)))];
            Run(2);
        }

        public SimulatedRadio Radio { get; }

        public Vehicle[] Vehicles { get; }

        public SimulatedGroundStation[] Stations { get; }

        public void Run(double seconds)
        {
            for (TimeSpan end = _now + TimeSpan.FromSeconds(seconds); _now < end;)
            {
                _now += SimulatedRadioOptions.MinLatency;
                foreach (Vehicle vehicle in Vehicles)
                    vehicle.Step(_now);
                foreach (SimulatedGroundStation station in Stations)
                    station.Step(_now);
                Radio.Exchange(_now);
            }
        }
    }

    private sealed class Vehicle(byte id, IByteLink link)
    {
        private readonly MavlinkSender _sender = new(id, 191);
        private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);
        private readonly byte[] _buffer = new byte[4096];
        private MavlinkHeartbeatSender? _heartbeats;
        private MavlinkCommandServer? _server;

        public byte Id { get; } = id;

        public MavResult Result { get; set; } = MavResult.Accepted;

        public List<MavlinkCommand> Obeyed { get; } = [];

        public MavlinkCommandServer Server => _server ??= new MavlinkCommandServer(
            _sender, new MavlinkCommandServerOptions { HandlesAllSystems = true });

        public void Step(TimeSpan now)
        {
            _heartbeats ??= new MavlinkHeartbeatSender(
                _sender, new Heartbeat { Type = MavType.OnboardController, MavlinkVersion = 3 });
            while (link.Read(_buffer) is { Kind: LinkReadKind.Bytes } read)
            {
                var bytes = new ReadOnlySpan<byte>(_buffer, 0, read.Count);
                while (_reader.TryRead(ref bytes, out MavlinkFrame frame, out _))
                    Server.Handle(frame, now);
            }

            while (Server.TryTakeRequest(out MavlinkCommandRequest request))
            {
                Obeyed.Add(request.Command);
                Server.Complete(request.Handle, Result, now);
            }

            while (_heartbeats.TryTakeFrame(now, out MavlinkFrame next) || Server.TryTakeFrame(now, out next))
                link.Write(_buffer, 0, next.WriteTo(_buffer));
        }
    }
}
