using System;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Simulation;

namespace Rabit.Documentation.Tests;

/// <summary>The six managers with a link and a camera, wired as in flight; no unit of work is executed.</summary>
internal static class ComposedSystem
{
    /// <summary>The wiring as <see cref="RabitWorkspace.DescribeWiring"/> gives it.</summary>
    public static string DescribeWiring(WiringFormat format)
    {
        var world = new SimulatedWorld(new SimulationOptions());
        using UavSystem uav = UavSystem.Open(new UavOptions
        {
            OpenLinks = [new MemoryLinkPair("autopilot").A],
            Camera = world.CreateCamera(),
            Imaging = new ImageProcessingOptions { Camera = world.CameraModel },
            Time = new VirtualTime(seed: 1),
        });

        // The wiring exists from the start on; in virtual time nothing runs before the test says for how long.
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });
        reactor.Start();
        string wiring = reactor.Workspace.DescribeWiring(format);
        reactor.Stop();
        reactor.Finish();
        return wiring;
    }
}
