using BenchmarkDotNet.Attributes;
using Rabit.Geodesy;
using Rabit.Uav.Simulation;

namespace Rabit.Benchmarks.Uav;

/// <summary>
/// A picture of the simulated ground of 640 x 480, and what the sensor adds to it: with AVX2, and one pixel at a time
/// as on other processors and Mono.
/// </summary>
[MemoryDiagnoser]
public class SimulatedPictureBenchmarks
{
    private GroundPainter _painter = null!;
    private SensorFinish _finish = null!;
    private CameraPose _pose;
    private byte[] _pixels = null!;
    private long _number;

    [Params(false, true)]
    public bool Vectors { get; set; }

    [GlobalSetup]
    public void Make()
    {
        var options = new SimulatedCameraOptions();
        var lens = new LensRays(options.Camera);
        _painter = new GroundPainter(lens, new GroundTexture(seed: 1));
        _finish = new SensorFinish(lens.Width, lens.Height, options.NoiseSigma, seed: 1);
        _painter.UsesVectors &= Vectors;
        _finish.UsesVectors &= Vectors;
        _pose = new CameraPose(
            new TruePose { Position = new NedPosition(20, 30, -40), CameraPitch = Angle.FromDegrees(-80) }, options);
        _pixels = new byte[lens.Width * lens.Height * 3];
    }

    [Benchmark]
    public void Ground() => _painter.Paint(_pose, _pixels);

    [Benchmark]
    public void Sensor() => _finish.Apply(_pixels, _number++);
}
