using BenchmarkDotNet.Attributes;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Benchmarks.Uav;

/// <summary>What one report costs beyond the search: where it stands, and how uncertain that is.</summary>
public class GroundProjectorBenchmarks
{
    private readonly GroundProjection _projection = NadirView.CreateProjection();

    [Benchmark(Baseline = true)]
    public GeodeticPosition Locate()
    {
        _projection.TryProjectToGround(500.25, 100.75, out GeodeticPosition place);
        return place;
    }

    [Benchmark]
    public HorizontalCovariance Covariances()
    {
        _projection.TryCovariances(
            500.25, 100.75, out HorizontalCovariance random, out HorizontalCovariance systematic);
        return random + systematic;
    }
}
