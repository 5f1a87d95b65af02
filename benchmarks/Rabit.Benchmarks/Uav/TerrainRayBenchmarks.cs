using BenchmarkDotNet.Attributes;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Benchmarks.Uav;

/// <summary>
/// A line of sight from 1600 m to ground of 100 m, in a grid of one degree with one post of 3400 m (the whole way
/// lies below that), and the same over level ground.
/// </summary>
public class TerrainRayBenchmarks
{
    private const int Posts = 1201;
    private static readonly Angle Step = Angle.FromDegrees(1.0 / 1200);

    private readonly LocalNedFrame _frame = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(47.1, 8.2, 1600));
    private readonly GroundRay _ray = new(default, new NedVector(20_000, 24_000, 1500));
    private TerrainGrid _terrain = null!;

    [GlobalSetup]
    public void MakeGrid()
    {
        float[] posts = new float[Posts * Posts];
        for (int i = 0; i < posts.Length; i++)
            posts[i] = 100 + (i % 7);
        posts[posts.Length - 1000] = 3400;
        _terrain = new TerrainGrid(
            new GeographicPoint(Angle.FromDegrees(47), Angle.FromDegrees(8)), Step, Step, Posts, Posts, posts);
    }

    [Benchmark(Baseline = true)]
    public NedPosition Level()
    {
        _ray.TryIntersectLevel(1500, Angle.FromDegrees(1), out NedPosition point);
        return point;
    }

    [Benchmark]
    public NedPosition Terrain()
    {
        TerrainRay.Intersect(_ray, _frame, _terrain, Angle.FromDegrees(1), out NedPosition point);
        return point;
    }
}
