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
    private readonly LocalNedFrame _frame = LocalNedFrame.IgnoringGeoid(TerrainWithPeak.Viewer);
    private readonly GroundRay _ray = new(default, new NedVector(20_000, 24_000, 1500));
    private TerrainGrid _terrain = null!;

    [GlobalSetup]
    public void MakeGrid() => _terrain = TerrainWithPeak.Make();

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
