using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>What lies about in the simulated world: the targets by colour, and the things that are like them.</summary>
internal static class TargetKinds
{
    /// <summary>Nominal colours of the panels that are targets.</summary>
    public static readonly TargetKind[] Panels =
    [
        new("red panel", DefaultTargetClasses.Red, new SurfaceColour(205, 28, 32), 1, 1),
        new("orange panel", DefaultTargetClasses.Orange, new SurfaceColour(242, 112, 18), 1, 1),
        new("blue panel", DefaultTargetClasses.Blue, new SurfaceColour(28, 72, 205), 1, 1),
        new("yellow panel", DefaultTargetClasses.Yellow, new SurfaceColour(243, 214, 28), 1, 1),
        new("magenta panel", DefaultTargetClasses.Magenta, new SurfaceColour(212, 36, 150), 1, 1),
    ];

    /// <summary>
    /// Things that are no targets: near colours of the right size, and right colours of the wrong size or form. In
    /// the order in which they are laid out, so that even a few have something of each sort.
    /// </summary>
    public static readonly TargetKind[] Distractors =
    [
        new("rusty sheet", TargetClassName.None, new SurfaceColour(122, 64, 42), 1.1, 0.9),
        new("grey-blue tarpaulin", TargetClassName.None, new SurfaceColour(84, 100, 134), 1.2, 1.0),
        new("patch of straw", TargetClassName.None, new SurfaceColour(204, 184, 118), 1.0, 1.0),
        new("red scrap", DefaultTargetClasses.Red, new SurfaceColour(205, 28, 32), 0.25, 0.25),
        new("orange strip", DefaultTargetClasses.Orange, new SurfaceColour(242, 112, 18), 3, 0.3),
        new("brown-red crate", TargetClassName.None, new SurfaceColour(134, 58, 54), 1.0, 1.0),
        new("blue scrap", DefaultTargetClasses.Blue, new SurfaceColour(28, 72, 205), 0.25, 0.25),
        new("heather", TargetClassName.None, new SurfaceColour(136, 92, 126), 1.2, 1.1),
        new("yellow strip", DefaultTargetClasses.Yellow, new SurfaceColour(243, 214, 28), 3, 0.3),
        new("clay slab", TargetClassName.None, new SurfaceColour(176, 112, 78), 1.0, 1.2),
    ];
}
