using System;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Nothing is allocated per frame.</summary>
public class ProtocolAllocationTests
{
    [Fact]
    public void AllClients_WholeExchanges_AllocateNothing()
    {
        MavlinkSender companion = ScriptedVehicle.Companion();
        var vehicle = new MavlinkSender(1, 1);
        var commands = new MavlinkCommandClient(companion);
        var parameters = new MavlinkParameterClient(
            companion, ScriptedVehicle.Address, MavlinkParameterEncoding.Bytewise);
        var missions = new MavlinkMissionClient(companion, ScriptedVehicle.Address);
        var rates = new MavlinkRateClient(companion, ScriptedVehicle.Address, [(Attitude.MavlinkId, 10)]);
        var time = new MavlinkTimesyncClient(companion, ScriptedVehicle.Address);
        var tracker = new MavlinkHeartbeatTracker();
        var name = new Text16("A_PARAMETER");
        TimeSpan now = TimeSpan.FromSeconds(1);
        var items = new MissionItemInt[50];
        int done = 0;
        Action work = () =>
        {
            now += TimeSpan.FromSeconds(10);
            commands.TryStart(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.DoSetMode), now, out _);
            commands.TryTakeFrame(now, out _);
            commands.Handle(vehicle.Create(new CommandAck { Command = MavCmd.DoSetMode }), now);
            done += commands.TryTakeOutcome(out _) ? 1 : 0;

            parameters.TryStartList(now);
            parameters.TryTakeFrame(now, out _);
            for (int i = 0; i < 50; i++)
            {
                name[11] = (byte)('A' + i);
                parameters.Handle(
                    vehicle.Create(new ParamValue { ParamId = name, ParamCount = 50, ParamIndex = (ushort)i }), now);
            }

            done += parameters.TryTakeOutcome(out _) ? 1 : 0;
            missions.TryStartDownload(MavMissionType.Mission, now);
            missions.TryTakeFrame(now, out _);
            missions.Handle(vehicle.Create(new MissionCount { Count = 50 }), now);
            for (int i = 0; i < 50; i++)
            {
                missions.TryTakeFrame(now, out _);
                missions.Handle(vehicle.Create(new MissionItemInt { Seq = (ushort)i }), now);
            }

            missions.TryTakeFrame(now, out _);
            done += missions.TryTakeOutcome(out _) ? 1 : 0;
            rates.TryTakeFrame(now, out _);
            rates.Handle(vehicle.Create(default(Attitude)), now);
            time.TryTakeFrame(now, out MavlinkFrame request);
            time.Handle(request, now);
            tracker.Handle(vehicle.Create(default(Heartbeat)), now);
            while (tracker.TryTakeEvent(now, out _, out _))
                done += 0;

            now += TimeSpan.FromSeconds(10);
            parameters.TryStartRead("A_PARAMETERA", now);
            parameters.TryTakeFrame(now, out _);
            parameters.Handle(vehicle.Create(Report(name, 'A', 0)), now);
            done += parameters.TryTakeOutcome(out MavlinkParameterOutcome read)
                && read.Status == MavlinkParameterStatus.Done
                ? 1
                : 0;
            now += TimeSpan.FromSeconds(10);
            parameters.TryStartSet("A_PARAMETERB", MavParamType.Real32, 7, now);
            parameters.TryTakeFrame(now, out _);
            parameters.Handle(vehicle.Create(Report(name, 'B', 7)), now);
            done += parameters.TryTakeOutcome(out MavlinkParameterOutcome set)
                && set.Status == MavlinkParameterStatus.Done
                ? 1
                : 0;

            missions.TryStartUpload(MavMissionType.Fence, items, now);
            missions.TryTakeFrame(now, out _);
            for (int i = 0; i < items.Length; i++)
            {
                missions.Handle(
                    vehicle.Create(new MissionRequestInt { Seq = (ushort)i, MissionType = MavMissionType.Fence }), now);
                missions.TryTakeFrame(now, out _);
            }

            missions.Handle(vehicle.Create(new MissionAck { MissionType = MavMissionType.Fence }), now);
            done += missions.TryTakeOutcome(out MavlinkMissionOutcome upload)
                && upload.Status == MavlinkMissionStatus.Done
                ? 1
                : 0;
            now += TimeSpan.FromSeconds(10);
            missions.TryStartClear(MavMissionType.Rally, now);
            missions.TryTakeFrame(now, out _);
            missions.Handle(vehicle.Create(new MissionAck { MissionType = MavMissionType.Rally }), now);
            done += missions.TryTakeOutcome(out MavlinkMissionOutcome clear)
                && clear.Status == MavlinkMissionStatus.Done
                ? 1
                : 0;
        };
        work();
        Assert.Equal(7, done);
        Assert.Equal(0, Allocated.By(work));
    }

    [Fact]
    public void CommandAndParameterServers_WholeExchanges_AllocateNothing()
    {
        var station = new MavlinkSender(255, 190);
        var vehicle = new MavlinkSender(1, 1);
        var commands = new MavlinkCommandServer(vehicle);
        var list = new MavlinkParameterList();
        for (int i = 0; i < 50; i++)
            list.Add($"P{i}", MavParamType.Real32, i);
        var parameters = new MavlinkParameterServer(
            vehicle, list, MavlinkParameterEncoding.Bytewise, new MavlinkParameterServerOptions { SendsHash = true });
        var name = new Text16("P7");
        TimeSpan now = TimeSpan.FromSeconds(1);
        int done = 0;
        Action work = () =>
        {
            now += TimeSpan.FromSeconds(60);
            for (byte copy = 0; copy < 3; copy++)
            {
                commands.Handle(
                    station.Create(MavlinkCommand.Create(ScriptedVehicle.Address, MavCmd.NavLand).ToLong(copy)), now);
                while (commands.TryTakeRequest(out MavlinkCommandRequest request))
                    commands.Complete(request.Handle, MavResult.Accepted, now);
                while (commands.TryTakeFrame(now, out _))
                    done++;
            }

            parameters.Handle(station.Create(new ParamRequestList { TargetSystem = 1, TargetComponent = 1 }), now);
            parameters.Handle(
                station.Create(new ParamRequestRead { TargetSystem = 1, TargetComponent = 1, ParamIndex = 3 }), now);
            parameters.Handle(station.Create(new ParamSet
            {
                TargetSystem = 1,
                TargetComponent = 1,
                ParamId = name,
                ParamType = MavParamType.Real32,
                ParamValue = done,
            }), now);
            for (; parameters.NextDue < TimeSpan.MaxValue; now += TimeSpan.FromSeconds(0.02))
            {
                while (parameters.TryTakeFrame(now, out _))
                    done++;
            }
        };
        work();
        Assert.Equal(3 + 1 + 50 + 2, done);
        Assert.Equal(0, Allocated.By(work));
    }

    private static ParamValue Report(Text16 name, char last, float value)
    {
        name[11] = (byte)last;
        return new ParamValue
        {
            ParamId = name,
            Value = value,
            ParamType = MavParamType.Real32,
            ParamCount = 50,
            ParamIndex = (ushort)(last - 'A')
        };
    }
}
