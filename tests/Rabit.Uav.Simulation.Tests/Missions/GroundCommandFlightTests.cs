using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.GroundControl;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>A ground station on a second link commands the mission, with all managers and both autopilots.</summary>
public sealed class GroundCommandFlightTests : IDisposable
{
    private const byte Station = 255;
    private const byte Computer = 191;

    private static readonly TimeSpan TestTimeout = TimeSpan.FromMinutes(10);

    private readonly ITestOutputHelper _output;
    private readonly MemoryLinkPair _link = new("ground station", 4 * 1024 * 1024);
    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);
    private readonly byte[] _buffer = new byte[64 * 1024];
    private byte _sequence;

    public GroundCommandFlightTests(ITestOutputHelper output) => _output = output;

    public void Dispose()
    {
        _link.A.Dispose();
        _link.B.Dispose();
    }

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Commands_OfAGroundStation_HoldContinueChangeSpeedAndReturn(SimulatedAutopilot autopilot)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        world.Autopilot = autopilot;
        using var flight = new SearchFlight(
            SearchFlight.SmallPlan(), world, new VirtualTime(world.Seed), [], groundStation: _link.A);
        flight.FlyUntil(f => f.Mission.Phase == MissionPhase.Searching, TestTimeout);

        // To the autopilot and to all components: not ours.
        Send(MavCmd.DoPauseContinue, 0, component: 0);
        Assert.DoesNotContain(AnswersAfter(flight, seconds: 3), a => a.Component == Computer);
        Assert.NotEqual(MissionPhase.Holding, flight.Mission.Phase);

        Assert.Equal(MavResult.Accepted, Command(flight, MavCmd.DoPauseContinue, 0));
        Assert.Equal(MissionPhase.Holding, flight.Mission.Phase);
        Assert.Equal(MavResult.Accepted, Command(flight, MavCmd.DoPauseContinue, 1));
        flight.FlyUntil(f => f.Mission.Phase == MissionPhase.Searching, TestTimeout);
        Assert.Equal(MavResult.Accepted, Command(flight, MavCmd.DoChangeSpeed, 1, 3));
        Assert.Equal(MavResult.Failed, Command(flight, MavCmd.DoChangeSpeed, 1, 300));
        Assert.Equal(MavResult.Unsupported, Command(flight, MavCmd.DoSetServo, 1, 2));
        Assert.Equal(MavResult.Accepted, Command(flight, MavCmd.NavReturnToLaunch, 0));
        flight.FlyUntil(f => f.IsOver, TestTimeout);
        flight.End();
        _output.WriteLine(flight.Log);

        Assert.Equal(MissionPhase.Done, flight.Mission.Phase);
        Assert.False(flight.World.Truth.IsAirborne);
        Assert.Contains("operator system 255 component 190", flight.Log, StringComparison.Ordinal);
    }

    // As LiveMissionTests flies it over UDP.
    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Story_OfAGroundStation_IsAnsweredAndFlown(SimulatedAutopilot autopilot)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        world.Autopilot = autopilot;
        using var flight = new SearchFlight(
            SearchFlight.SmallPlan(), world, new VirtualTime(world.Seed), [], groundStation: _link.A);
        flight.Reactor.Start();
        var story = new GroundStationStory(
            bytes => _link.B.Write(bytes, 0, bytes.Length), Received,
            () => flight.Reactor.RunFor(TimeSpan.FromMilliseconds(100)) && flight.Reactor.Now < TestTimeout,
            () => flight.Log);
        try
        {
            story.Play();
        }
        finally
        {
            flight.End();
            _output.WriteLine(string.Join("\n", story.Answers));
            _output.WriteLine(string.Join("\n", story.Texts));
            _output.WriteLine(flight.Log);
        }

        Assert.False(flight.World.Truth.IsAirborne);
        Assert.False(flight.World.Truth.HasCrashed);
    }

    // A ground station uploads it to the autopilot, not to us.
    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Fence_OfTheAutopilotChangedInMidSearch_IsTakenOverAsAnArea(SimulatedAutopilot autopilot)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        world.Autopilot = autopilot;
        using var flight = new SearchFlight(
            SearchFlight.SmallPlan(), world, new VirtualTime(world.Seed), [], groundStation: _link.A,
            commands: new GroundCommandOptions { OffersAutopilotFence = true });
        flight.FlyUntil(f => f.Mission.Phase == MissionPhase.Searching, TestTimeout);
        Upload(flight, Corners(47.39680, 8.54410, 47.39870, 8.54690));
        flight.FlyUntil(f => f.Log.Contains("area offered"), flight.Reactor.Now + TimeSpan.FromSeconds(30));
        Assert.Contains("the autopilot's fence was changed: area offered", flight.Log, StringComparison.Ordinal);
        Assert.Equal(MavResult.Accepted, Command(flight, MavCmd.DoPauseContinue, 1));
        Assert.InRange(flight.Mission.Plan!.Area.Max(c => c.Latitude.Degrees), 47.39810, 47.39865);
        flight.FlyUntil(f => f.IsOver, TestTimeout);
        flight.End();
        _output.WriteLine(flight.Log);
        Assert.Equal(MissionPhase.Done, flight.Mission.Phase);
        Assert.InRange(flight.Mission.Coverage, 0.98, 1);
        Assert.DoesNotContain("breach", flight.Log, StringComparison.OrdinalIgnoreCase);
        Assert.False(flight.World.Truth.HasCrashed);
    }

    // The mission itself revisits nothing.
    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Revisit_OfATargetByCommand_IsAcceptedAndFlown(SimulatedAutopilot autopilot)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        world.Autopilot = autopilot;
        MissionPlan plan = MissionPlan.Parse(
            SearchFlight.SmallMission.Replace("\"home\"", "\"revisit\": { \"enabled\": false }, \"home\""), "small");
        using var flight = new SearchFlight(
            plan, world, new VirtualTime(world.Seed), [], groundStation: _link.A);
        flight.FlyUntil(f => f.Tracks.ConfirmedCount > 0 || f.IsOver, TestTimeout);
        TargetTrack target = flight.Tracks.Tracks.First(t => t.State == TrackState.Confirmed);
        Assert.Equal(MavResult.Failed, Command(flight, MavCmd.User1, 2, 99));
        Assert.Equal(MavResult.Accepted, Command(flight, MavCmd.User1, 2, target.Id));
        Assert.Equal(MissionPhase.Revisiting, flight.Mission.Phase);
        int reports = target.Reports;
        flight.FlyUntil(f => f.Mission.Phase == MissionPhase.Searching || f.IsOver, TestTimeout);
        flight.FlyUntil(f => f.IsOver, TestTimeout);
        flight.End();
        _output.WriteLine(flight.Log);
        Assert.Equal(MissionPhase.Done, flight.Mission.Phase);
        Assert.Equal(1, flight.Mission.Revisits);
        Assert.True(flight.Tracks.Tracks.First(t => t.Id == target.Id).Reports > reports);
    }

    private void Upload(SearchFlight flight, MissionItemInt[] items)
    {
        var client = new MavlinkMissionClient(new MavlinkSender(Station, 190), new MavlinkAddress(1, 1));
        client.TryStartUpload(MavMissionType.Fence, items, flight.Reactor.Now);
        MavlinkMissionOutcome outcome = default;
        for (int i = 0; i < 200 && !client.TryTakeOutcome(out outcome); i++)
        {
            while (client.TryTakeFrame(flight.Reactor.Now, out MavlinkFrame frame))
                _link.B.Write(_buffer, 0, frame.WriteTo(_buffer));
            flight.Reactor.RunFor(TimeSpan.FromMilliseconds(50));
            foreach (MavlinkFrame frame in Received())
                client.Handle(frame, flight.Reactor.Now);
        }

        Assert.Equal(MavlinkMissionStatus.Done, outcome.Status);
    }

    private static MissionItemInt[] Corners(double south, double west, double north, double east)
        => new[] { (south, west), (north, west), (north, east), (south, east) }.Select(c => new MissionItemInt
        {
            Command = MavCmd.NavFencePolygonVertexInclusion,
            Frame = MavFrame.Global,
            Param1 = 4,
            X = (int)Math.Round(c.Item1 * 1e7),
            Y = (int)Math.Round(c.Item2 * 1e7),
        }).ToArray();

    private void Send(MavCmd command, float p1, float p2 = 0, byte component = Computer)
    {
        var message = new CommandLong
        {
            TargetSystem = 1,
            TargetComponent = component,
            Command = command,
            Param1 = p1,
            Param2 = p2,
        };
        int length = MavlinkFrame.Create(message, Station, 190, _sequence++).WriteTo(_buffer);
        _link.B.Write(_buffer, 0, length);
    }

    private MavResult Command(SearchFlight flight, MavCmd command, float p1, float p2 = 0)
    {
        Send(command, p1, p2);
        MavResult? result = null;
        foreach ((byte component, CommandAck ack) in AnswersAfter(flight, seconds: 5))
        {
            if (component == Computer && ack.Command == command && ack.Result != MavResult.InProgress)
                result = ack.Result;
        }

        return result ?? throw new Xunit.Sdk.XunitException($"{command} is not answered");
    }

    private List<(byte Component, CommandAck Ack)> AnswersAfter(SearchFlight flight, double seconds)
    {
        TimeSpan until = flight.Reactor.Now + TimeSpan.FromSeconds(seconds);
        flight.FlyUntil(f => f.Reactor.Now >= until, TestTimeout);
        var answers = new List<(byte Component, CommandAck Ack)>();
        foreach (MavlinkFrame frame in Received())
        {
            if (frame.TryDecode(out CommandAck ack))
                answers.Add((frame.ComponentId, ack));
        }

        return answers;
    }

    private List<MavlinkFrame> Received()
    {
        var frames = new List<MavlinkFrame>();
        while (_link.B.Read(_buffer) is { Count: > 0 } read)
        {
            var rest = new ReadOnlySpan<byte>(_buffer, 0, read.Count);
            while (_reader.TryRead(ref rest, out MavlinkFrame frame, out _))
                frames.Add(frame);
        }

        return frames;
    }
}
