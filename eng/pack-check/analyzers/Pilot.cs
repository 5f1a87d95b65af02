using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core;

public sealed class Pilot : RabitManager
{
    private readonly Random _random = new Random();

    public Pilot() : base("pilot") => Receive<List<int>>("orders");

    protected override async void Startup() => await Task.Yield();

    protected override void ExecuteUnitOfWork()
    {
        Thread.Sleep(_random.Next(5));
        Log(DateTime.Now.ToString());
        Publish<int>("height");
    }
}
