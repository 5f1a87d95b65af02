using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

// What only ground stations ask for: the remote control, the flight modes.
internal sealed partial class TelemetrySender
{
    private const ushort Centred = 1500;
    private const int Channels = 8;

    /// <summary>Sends what a flight mode is; false where there is none of that number.</summary>
    /// <param name="index">From 1; 0 for all of them.</param>
    public bool SendModes(int index)
    {
        int count = CopterModes.All.Count;
        if (index < 0 || index > count)
            return false;
        for (int mode = index == 0 ? 1 : index; mode <= (index == 0 ? count : index); mode++)
        {
            CopterMode number = CopterModes.All[mode - 1];
            sink.Send(new AvailableModes
            {
                NumberModes = (byte)count,
                ModeIndex = (byte)mode,
                StandardMode = CopterModes.StandardOf(number),
                CustomMode = (uint)number,
                ModeName = new Text35(CopterModes.NameOf(number)),
            });
        }

        return true;
    }

    // The sticks are centred. What is not received has no channels.
    private void SendChannels()
    {
        bool isReceived = !controller.Failsafes.Radio.IsOn;
        sink.Send(new RcChannels
        {
            TimeBootMs = BootMilliseconds,
            Chancount = (byte)(isReceived ? Channels : 0),
            Chan1Raw = Centred,
            Chan2Raw = Centred,
            Chan3Raw = Centred,
            Chan4Raw = Centred,
            Chan5Raw = Centred,
            Chan6Raw = Centred,
            Chan7Raw = Centred,
            Chan8Raw = Centred,
            Rssi = (byte)(isReceived ? byte.MaxValue - 1 : 0),
        });
    }
}
