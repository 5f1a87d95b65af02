using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>
/// Where the made-up flight is flown: home, the area with its fence, and the lanes.
/// </summary>
internal static class MadeUpSite
{
    public const double HeightMetres = 40;
    public const double Speed = 6;
    private static readonly NedPosition[] Area = [new(20, 20, 0), new(140, 20, 0), new(140, 180, 0), new(20, 180, 0)];

    public static IReadOnlyList<double> LaneNorths { get; } = [35, 65, 95, 125];

    public static GeodeticPosition Home { get; } = GeodeticPosition.FromDegrees(47.39697, 8.54426, 488);

    public static LocalNedFrame Frame { get; } = LocalNedFrame.IgnoringGeoid(Home);

    public static SearchPlan Plan { get; } = new()
    {
        Name = "search of a meadow",
        Home = Home,
        Area = [.. Area.Select(Frame.ToGeodetic)],
        Fence =
        [
            .. new[]
            {
                new NedPosition(-15, -15, 0),
                new NedPosition(160, -15, 0),
                new NedPosition(160, 200, 0),
                new NedPosition(-15, 200, 0)
            }
                .Select(Frame.ToGeodetic)
        ],
        Lanes =
        [
            .. LaneNorths.SelectMany((n, i) => i % 2 == 0 ? new[] { (n, 20.0), (n, 180.0) } : [(n, 180.0), (n, 20.0)])
                .Select(p => Frame.ToGeodetic(new NedPosition(p.Item1, p.Item2, -HeightMetres)))
        ],
        HeightAboveHomeMetres = HeightMetres,
        SpeedMetresPerSecond = Speed,
    };
}
