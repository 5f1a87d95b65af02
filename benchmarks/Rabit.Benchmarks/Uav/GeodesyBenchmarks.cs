using BenchmarkDotNet.Attributes;
using Rabit.Geodesy;

namespace Rabit.Benchmarks.Uav;

/// <summary>One conversion of a position each.</summary>
public class GeodesyBenchmarks
{
    private readonly GeographicPoint _here = new(Angle.FromDegrees(47.4), Angle.FromDegrees(8.5));
    private readonly GeographicPoint _there = new(Angle.FromDegrees(47.5), Angle.FromDegrees(8.7));
    private readonly GeographicPoint _opposite = new(Angle.FromDegrees(-47.3), Angle.FromDegrees(-171.7));
    private readonly EllipsoidPosition _place = new(
        new GeographicPoint(Angle.FromDegrees(47.4), Angle.FromDegrees(8.5)), new EllipsoidHeight(500));
    private readonly Rotation _attitude = Rotation.FromEuler(EulerAngles.FromRadians(0.1, 0.2, 0.3));
    private EulerAngles _angles;
    private EcefPosition _ecef;
    private UtmPosition _utm;
    private LocalNedFrame _frame;

    [GlobalSetup]
    public void SetUp()
    {
        _angles = _attitude.ToEuler();
        _ecef = _place.ToEcef();
        _utm = UtmPosition.From(_here);
        _frame = LocalNedFrame.IgnoringGeoid(_place.ToAmsl(0));
    }

    [Benchmark(Baseline = true)]
    public EcefPosition ToEcef() => _place.ToEcef();

    [Benchmark]
    public EllipsoidPosition FromEcef() => EllipsoidPosition.FromEcef(_ecef);

    [Benchmark]
    public NedPosition ToNed()
        => _frame.ToNed(GeodeticPosition.FromRadians(_there.Latitude.Radians, _there.Longitude.Radians, 500));

    [Benchmark]
    public GeodeticPosition FromNed() => _frame.ToGeodetic(new NedPosition(1000, 2000, 10));

    [Benchmark]
    public GeodesicLine Inverse() => Geodesic.Inverse(_here, _there);

    [Benchmark]
    public GeodesicLine InverseNearlyAntipodal() => Geodesic.Inverse(_here, _opposite);

    [Benchmark]
    public GeographicPoint Direct() => Geodesic.Direct(_here, Angle.FromDegrees(30), 20_000, out _);

    [Benchmark]
    public UtmPosition ToUtm() => UtmPosition.From(_here);

    [Benchmark]
    public GeographicPoint FromUtm() => _utm.ToGeographic();

    [Benchmark]
    public MgrsPosition ToMgrs() => MgrsPosition.From(_here);

    [Benchmark]
    public EulerAngles ToEuler() => _attitude.ToEuler();

    [Benchmark]
    public Rotation FromEuler() => Rotation.FromEuler(_angles);
}
