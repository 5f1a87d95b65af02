using System;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;

// Six managers fly a small search in a simulated world, in virtual time: minutes of flight in a second, and the same
// each time.
MissionPlan mission = MissionPlan.Parse(
    """
    {
      "name": "small meadow",
      "area": [[47.39730, 8.54470], [47.39780, 8.54470], [47.39780, 8.54560], [47.39730, 8.54560]],
      "heightMetres": 30, "speedMetresPerSecond": 5, "laneSpacingMetres": 22
    }
    """,
    "SimulatedSearch");

var worldOptions = new SimulationOptions { Seed = 4, TargetCount = 2 };
worldOptions.TakePlacesFrom(mission);
var world = new SimulatedWorld(worldOptions);
var telemetry = new MemoryLinkPair("telemetry");

using UavSystem uav = UavSystem.Open(new UavOptions
{
    OpenLinks = [telemetry.A],
    OtherManagers = [world.CreateVehicle(telemetry.B)],
    Mission = mission,
    MayCommand = true,   // without it we only observe
    Camera = world.CreateCamera(),
    Imaging = new ImageProcessingOptions { Camera = world.CameraModel, Mount = world.CameraMount },
    Time = new VirtualTime(worldOptions.Seed),
});

RabitReactor reactor = uav.CreateReactor(new ReactorOptions());
MessageSubscriber<MissionStatus> status = reactor.Workspace.Subscribe<MissionStatus>(MessageNames.Mission);
MessageSubscriber<TrackList> tracks = reactor.Workspace.Subscribe<TrackList>(MessageNames.Tracks);

reactor.Start();
while (reactor.Now < TimeSpan.FromMinutes(20)
    && status.Value.Phase is not (MissionPhase.Done or MissionPhase.Failed or MissionPhase.HandedOver))
{
    MissionPhase before = status.Value.Phase;
    if (!reactor.RunFor(TimeSpan.FromSeconds(1)))
        break;
    status.Fetch();
    if (status.Value.Phase != before)
        Console.WriteLine(
            FormattableString.Invariant(
                $"{reactor.Now.TotalSeconds,4:0} s  {status.Value.Phase}: {status.Value.Text}"));
}

reactor.Stop();
ReactorResult result = reactor.Finish();
tracks.Fetch();
foreach (TargetTrack track in tracks.Value.Tracks)
    Console.WriteLine(
        FormattableString.Invariant($"track {track.Id}: {track.Class}, {track.State}, {track.Reports} reports"));
Console.WriteLine($"landed {(world.Truth.Landing is null ? "nowhere" : "at home")}, "
    + $"{(result.ExitCode == 0 ? "no faults" : result.ToString())}");
return result.ExitCode;
