using Rabit.Core;

namespace Wheelchair.Devices;

/// <summary>
/// The motor controller of the simulated chair. A real one would write to a serial line or a CAN bus, and block.
/// </summary>
internal sealed class SimulatedMotors(SimulatedChair chair) : IWriterTarget<MotorCommand>
{
    public bool Blocks => false;

    public void Open()
    {
    }

    public void Write(in MotorCommand value) => chair.SetSpeed(value.SpeedMetresPerSecond, value.At);

    public void Unblock()
    {
    }

    public void Close()
    {
    }
}
