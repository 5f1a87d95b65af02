namespace Rabit.Benchmarks.Core;

/// <summary>A message of common size: 72 bytes.</summary>
internal struct VehiclePose
{
    public double TimeSeconds { get; set; }
    public double NorthMetres { get; set; }
    public double EastMetres { get; set; }
    public double DownMetres { get; set; }
    public double RollRadians { get; set; }
    public double PitchRadians { get; set; }
    public double YawRadians { get; set; }
    public double GroundSpeed { get; set; }
    public double ClimbRate { get; set; }
}
