using Rabit.Core;

namespace Wheelchair;

/// <summary>Reads the joystick and posts where it stands. When the driver gets off, the ride is over.</summary>
internal sealed class JoystickManager : RabitManager
{
    private readonly BlockingReader<double> _device;
    private readonly MessagePublisher<Joystick> _joystick;

    public JoystickManager(IReaderSource<double> device)
        : base("joystick")
    {
        _device = AttachReader("stick", device);   // wakes this manager with every reading
        _joystick = Publish<Joystick>("joystick");
    }

    protected override void ExecuteUnitOfWork()
    {
        while (_device.TryPop(out double forward))
        {
            _joystick.Value.Forward = forward;
            _joystick.Post();
        }

        if (_device.State == DeviceState.Ended)
            StopSystem("the driver got off");
    }
}
