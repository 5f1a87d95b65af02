using Rabit.Geodesy;

namespace Rabit.Benchmarks.Uav;

/// <summary>
/// A grid of one degree, of some 100 m, with one post of 3400 m, so that lines of sight from far above the ground are
/// below the highest post all the way.
/// </summary>
internal static class TerrainWithPeak
{
    private const int Posts = 1201;

    /// <summary>Where who looks across it is, 1600 m above mean sea level.</summary>
    public static readonly GeodeticPosition Viewer = GeodeticPosition.FromDegrees(47.1, 8.2, 1600);

    private static readonly Angle Step = Angle.FromDegrees(1.0 / 1200);

    public static TerrainGrid Make()
    {
        float[] posts = new float[Posts * Posts];
        for (int i = 0; i < posts.Length; i++)
            posts[i] = 100 + (i % 7);
        posts[posts.Length - 1000] = 3400;
        return new TerrainGrid(
            new GeographicPoint(Angle.FromDegrees(47), Angle.FromDegrees(8)), Step, Step, Posts, Posts, posts);
    }
}
